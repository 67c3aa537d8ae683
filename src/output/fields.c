/* fields.c -- the series of particle files and its index.
 *
 * XDMF 2: https://www.xdmf.org/index.php/XDMF_Model_and_Format */
#include "output/fields.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/fields-file.h"
#include <stdbool.h>
#include <stdlib.h>

struct fields {
    char folder[ASIDE_PATH], index[ASIDE_PATH];
    int moments, room;
    const struct cloud_looks *looks; /* NULL: no rigid bodies */
    int safe;   /* moments whose files are on the disk */
    double *t;  /* [room] [s]        */
    long *n;    /* [room] particles  */
};

/* One array: TYPE its numbers, FILE fields/000012FILE.vtkhdf, PLACE its path in there. */
static void item_of(FILE *to, int number, const char *file, int rows, int columns, const char *type,
                    const char *place)
{
    fprintf(to, "<DataItem Dimensions=\"%d", rows);
    if (columns > 1)
        fprintf(to, " %d", columns);
    fprintf(to, "\" %s Format=\"HDF\">fields/%06d%s.vtkhdf:/%s</DataItem>", type, number, file,
            place);
}

/* Of the particles, below /VTKHDF. */
static void item(FILE *to, int number, int rows, int columns, const char *type, const char *place)
{
    char path[80];

    snprintf(path, sizeof path, "VTKHDF/%s", place);
    item_of(to, number, "", rows, columns, type, path);
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

static const char real[] = "NumberType=\"Float\" Precision=\"8\"";

static void time_of(FILE *to, double t)
{
    fprintf(to, "        <Time Value=\"%.17g\"/>\n", t);
}

static void particles(FILE *to, int number, double t, int n, bool alone)
{
    static const char byte[] = "NumberType=\"UChar\" Precision=\"1\"";
    static const char whole[] = "NumberType=\"Int\" Precision=\"4\"";

    fputs("      <Grid Name=\"particles\" GridType=\"Uniform\">\n", to);
    if (alone)
        time_of(to, t);
    fprintf(to, "        <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"%d\""
            " NodesPerElement=\"1\">\n          ", n);
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

static void bodies_item(FILE *to, int number, int rows, int columns, const char *type,
                        const char *place)
{
    item_of(to, number, "-bodies", rows, columns, type, place);
}

/* Names are told by their numbers. */
static void names(FILE *to, const struct cloud_looks *l)
{
    for (int i = 0; i < l->bodies; i++)
        fprintf(to, "        <Information Name=\"body %d\" Value=\"%s\"/>\n", i, l->name[i]);
}

static void bodies(FILE *to, int number, const struct cloud_looks *l)
{
    static const char whole[] = "NumberType=\"Int\" Precision=\"4\"";
    const int mixed = 2 * l->faces + l->first[l->faces];

    fputs("      <Grid Name=\"bodies\" GridType=\"Uniform\">\n", to);
    names(to, l);
    fprintf(to, "        <Topology TopologyType=\"Mixed\" NumberOfElements=\"%d\">\n          ",
            l->faces);
    bodies_item(to, number, mixed, 1, whole, "XDMF/Mixed");
    fputs("\n        </Topology>\n        <Geometry GeometryType=\"XYZ\">\n          ", to);
    bodies_item(to, number, l->corners, 3, real, "VTKHDF/Points");
    fputs("\n        </Geometry>\n        <Attribute Name=\"velocity\" AttributeType=\"Vector\" "
          "Center=\"Node\">\n          ", to);
    bodies_item(to, number, l->corners, 3, real, "VTKHDF/PointData/velocity");
    fputs("\n        </Attribute>\n        <Attribute Name=\"body\" AttributeType=\"Scalar\" "
          "Center=\"Cell\">\n          ", to);
    bodies_item(to, number, l->faces, 1, whole, "VTKHDF/CellData/body");
    fputs("\n        </Attribute>\n      </Grid>\n", to);
}

static void moment(const struct fields *f, FILE *to, int i)
{
    if (!f->looks) {
        particles(to, i, f->t[i], (int)f->n[i], true);
        return;
    }
    fputs("    <Grid Name=\"moment\" GridType=\"Collection\" CollectionType=\"Spatial\">\n", to);
    time_of(to, f->t[i]);
    if (f->n[i] > 0)
        particles(to, i, f->t[i], (int)f->n[i], false);
    bodies(to, i, f->looks);
    fputs("    </Grid>\n", to);
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
        moment(f, a.to, i);
    fputs("    </Grid>\n  </Domain>\n</Xdmf>\n", a.to);
    return aside_close(&a);
}

/* END: "" of particles, "-bodies" of bodies. */
static int file_of(const struct fields *f, int number, const char *end, char *path)
{
    char name[40];

    snprintf(name, sizeof name, "%06d%s.vtkhdf", number, end);
    return aside_join(path, f->folder, name);
}

static int start(struct fields *f, const char *dir)
{
    char path[ASIDE_PATH];

    TRY(aside_join(f->folder, dir, "fields"));
    TRY(aside_join(f->index, dir, "fields.xdmf"));
    TRY(file_of(f, 999999, "-bodies", path)); /* the longest: later no name is refused */
    return aside_directory(f->folder);
}

int fields_open(struct fields **out, const char *dir, const struct cloud_looks *looks)
{
    struct fields *f = status_alloc(1, sizeof *f);
    int code;

    *out = f;
    if (!f)
        return STATUS_FAILED;
    f->looks = looks;
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

/* A checkpoint promises the files that it counts. */
static int make_safe(struct fields *f)
{
    char path[ASIDE_PATH];

    for (; f->safe < f->moments; f->safe++) {
        TRY(file_of(f, f->safe, "", path));
        TRY(aside_sync(path));
        if (!f->looks)
            continue;
        TRY(file_of(f, f->safe, "-bodies", path));
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

/* What the first rank alone knows of. */
static int add(struct fields *f, const struct cloud_frame *frame)
{
    char path[ASIDE_PATH];

    if (f->looks) {
        TRY(file_of(f, f->moments, "-bodies", path));
        TRY(fields_bodies_write(path, frame));
    }
    TRY(remember(f, frame));
    return write_index(f);
}

int fields_write(struct fields *f, const struct cloud_frame *frame)
{
    char path[ASIDE_PATH];

    if (!f)
        return fields_file_write(NULL, frame);
    file_of(f, f->moments, "", path);
    TRY(fields_file_write(path, frame));
    return add(f, frame);
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
