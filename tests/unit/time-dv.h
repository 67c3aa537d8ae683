/* time-dv.h -- steps of "dv" without its frame, for tests. */
#ifndef TESTS_UNIT_TIME_DV_H
#define TESTS_UNIT_TIME_DV_H

#include "base/status.h"
#include "time/dv.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* n steps of length h. */
static inline void dv_steps(struct dv *x, int n, double h)
{
    struct paced *frame = &x->frame;

    for (int k = 0; k < n; k++) {
        double *const y = frame->y, *const d = x->d.f[0];
        frame->y = frame->y_old;
        frame->y_old = y;
        assert_int_equal(dv_advance(frame, h), STATUS_DONE);
        frame->t = frame->t_old = frame->t_old + h;
        x->d.f[0] = x->d.f[1];
        x->d.f[1] = d;
    }
}

#endif
