/* fields.c -- the series of particle files and its index.
 *
 * XDMF 2: https://www.xdmf.org/index.php/XDMF_Model_and_Format */
#include "output/fields.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/fields-file.h"
#include <stdlib.h>

struct fields {
    char folder[ASIDE_PATH], index[ASIDE_PATH];
    int moments, room;
    int safe;   /* moments whose files are on the disk */
    double *t;  /* [room] [s]        */
    long *n;    /* [room] particles  */
};

/* One array: TYPE is Scalar or Vector, PLACE its path below /VTKHDF. */
static void item(FILE *to, int number, int rows, int columns, const char *type, const char *place)
{
    fprintf(to, "<DataItem Dimensions=\"%d", rows);
    if (columns > 1)
        fprintf(to, " %d", columns);
    fprintf(to, "\" %s Format=\"HDF\">fields/%06d.vtkhdf:/VTKHDF/%s</DataItem>", type, number,
            place);
}

static void attribute(FILE *to, int number, int rows, int columns, const char *type,
                      const char *name)
{
    char place[64];

    snprintf(place, sizeof place, "PointData/%s", name);
    fprintf(to, "        <Attribute Name=\"%s\" AttributeType=\"%s\" Center=\"Node\">\n          ",
            name, columns > 1 ? "Vector" : "Scalar");
    item(to, number, rows, columns, type, place);
    fputs("\n        </Attribute>\n", to);
}

static void grid(FILE *to, int number, double t, int n)
{
    static const char real[] = "NumberType=\"Float\" Precision=\"8\"";
    static const char byte[] = "NumberType=\"UChar\" Precision=\"1\"";
    static const char whole[] = "NumberType=\"Int\" Precision=\"4\"";

    fprintf(to,
            "      <Grid Name=\"particles\" GridType=\"Uniform\">\n"
            "        <Time Value=\"%.17g\"/>\n"
            "        <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"%d\""
            " NodesPerElement=\"1\">\n          ",
            t, n);
    item(to, number, n, 1, "NumberType=\"Int\" Precision=\"8\"", "Connectivity");
    fputs("\n        </Topology>\n        <Geometry GeometryType=\"XYZ\">\n          ", to);
    item(to, number, n, 3, real, "Points");
    fputs("\n        </Geometry>\n", to);
    attribute(to, number, n, 3, real, "velocity");
    attribute(to, number, n, 1, real, "density");
    attribute(to, number, n, 1, real, "pressure");
    attribute(to, number, n, 1, byte, "dye");
    attribute(to, number, n, 1, byte, "kind");
    attribute(to, number, n, 1, whole, "id");
    fputs("      </Grid>\n", to);
}

static int write_index(const struct fields *f)
{
    struct aside a;

    TRY(aside_open(&a, f->index));
    fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          "<Xdmf Version=\"2.0\">\n  <Domain>\n"
          "    <Grid Name=\"moments\" GridType=\"Collection\" CollectionType=\"Temporal\">\n",
          a.to);
    for (int i = 0; i < f->moments; i++)
        grid(a.to, i, f->t[i], (int)f->n[i]);
    fputs("    </Grid>\n  </Domain>\n</Xdmf>\n", a.to);
    return aside_close(&a);
}

static int start(struct fields *f, const char *dir)
{
    TRY(aside_join(f->folder, dir, "fields"));
    TRY(aside_join(f->index, dir, "fields.xdmf"));
    return aside_directory(f->folder);
}

int fields_open(struct fields **out, const char *dir)
{
    struct fields *f = status_alloc(1, sizeof *f);
    int code;

    *out = f;
    if (!f)
        return STATUS_FAILED;
    code = start(f, dir);
    if (code != STATUS_DONE)
        fields_close(out);
    return code;
}

static int make_room(struct fields *f, int moments)
{
    const int room = 2 * moments + 64;
    double *t;
    long *n;

    if (moments <= f->room)
        return STATUS_DONE;
    if ((t = realloc(f->t, (size_t)room * sizeof *t)))
        f->t = t;
    if ((n = realloc(f->n, (size_t)room * sizeof *n)))
        f->n = n;
    if (!t || !n)
        return status_starved("%s cannot be kept", f->index);
    f->room = room;
    return STATUS_DONE;
}

static int remember(struct fields *f, const struct cloud_frame *frame)
{
    TRY(make_room(f, f->moments + 1));
    f->t[f->moments] = frame->t;
    f->n[f->moments++] = frame->n;
    return STATUS_DONE;
}

static int file_of(const struct fields *f, int number, char *path)
{
    char name[32];

    snprintf(name, sizeof name, "%06d.vtkhdf", number);
    return aside_join(path, f->folder, name);
}

/* A checkpoint promises the files that it counts. */
static int make_safe(struct fields *f)
{
    char path[ASIDE_PATH];

    for (; f->safe < f->moments; f->safe++) {
        TRY(file_of(f, f->safe, path));
        TRY(aside_sync(path));
    }
    return aside_sync(f->folder);
}

int fields_keep(struct fields *f, struct archive *a)
{
    if (!f)
        return STATUS_DONE;
    if (!archive_fills(a))
        TRY(make_safe(f));
    TRY(archive_integer(a, "fields", &f->moments));
    TRY(make_room(f, f->moments));
    TRY(archive_numbers(a, "fields.t", f->t, f->moments));
    TRY(archive_integers(a, "fields.particles", f->n, f->moments));
    if (!archive_fills(a) || archive_tries(a) || f->moments == 0)
        return STATUS_DONE;
    return write_index(f);
}

int fields_write(struct fields *f, const struct cloud_frame *frame)
{
    char path[ASIDE_PATH];

    TRY(file_of(f, f->moments, path));
    TRY(fields_file_write(path, frame));
    TRY(remember(f, frame));
    return write_index(f);
}

void fields_close(struct fields **fields)
{
    if (!*fields)
        return;
    free((*fields)->t);
    free((*fields)->n);
    free(*fields);
    *fields = NULL;
}
