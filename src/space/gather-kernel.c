/* gather-kernel.c -- what kernels give to rows, in either precision. */
#include "space/gather.h"

/* One division for all laws that soften 1/r^2. */
static void soften(double support, struct block *b)
{
    const real eta2 = (real)kernel_softening(support);

    for (int k = 0; k < b->n; k++)
        b->gw_r2[k] = b->gw[k] / (b->r2[k] + eta2);
}

void gather_kernel(unsigned needs, const struct kernel_use *use, struct block *b)
{
    const struct kernel_rows *kernel = use->kernel->rows;

    if ((needs & NEED_GRADW_R2) && kernel->both)
        kernel->both(use->support, use->scale, b->n, b->r, b->r2, b->mm, b->gw, b->gw_r2);
    else if (needs & (NEED_GRADW | NEED_GRADW_R2))
        kernel->gradient(use->support, use->scale, b->n, b->r, b->mm, b->gw);
    if ((needs & NEED_GRADW_R2) && !kernel->both)
        soften(use->support, b);
    if (needs & NEED_W)
        kernel->value(use->support, use->scale, b->n, b->r, b->mm, b->w);
    if (needs & NEED_LAPW)
        kernel->laplacian(use->support, use->scale, b->n, b->r, b->mm, b->lw);
}
