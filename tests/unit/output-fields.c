/* output-fields.c -- unit tests: particle files read back, an index that tells the truth. */
#include "output.h"

#include "base/status.h"
#include "output/cloud.h"
#include "output/fields.h"
#include "output/snapshot.h"

#include <hdf5.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>

enum { N = 30, MOMENTS = 3 };

/* Particle i at moment k: pressure 10 i + k, dye i % 2, kind i % 5. */
static struct cloud_frame sample(int dim, int k)
{
    static double x[3 * N], u[3 * N], rho[N], p[N];
    static unsigned char dye[N], kind[N];

    for (int i = 0; i < N; i++) {
        for (int d = 0; d < dim; d++) {
            x[dim * i + d] = i + 100 * d + 0.5 * k;
            u[dim * i + d] = i * d + k;
        }
        rho[i] = 1000 + i;
        p[i] = 10 * i + k;
        dye[i] = (unsigned char)(i % 2);
        kind[i] = (unsigned char)(i % 5);
    }
    return (struct cloud_frame){ .t = 0.1 * k + 0.01 * k * k, .n = N, .here = N, .dim = dim, .x = x, .u = u,
                                 .rho = rho, .p = p, .dye = dye, .kind = kind };
}

/* A tetrahedron that moves by (1, 1, 1). */
static struct cloud_looks sample_looks(int k)
{
    static const char *const name[] = { "stone" };
    static const int of[4] = { 0 }, first[] = { 0, 3, 6, 9, 12 };
    static const int loop[] = { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 };
    static double x[12], u[12];

    for (int i = 0; i < 12; i++) {
        x[i] = (i == 3 || i == 7 || i == 11 ? 3 : 0) + k;
        u[i] = i + 0.5 * k;
    }
    return (struct cloud_looks){ 1, 4, 4, name, x, u, of, first, loop };
}

int output_write_sample(const char *where, int dim)
{
    struct cloud_looks looks = sample_looks(0);
    struct fields *f;

    TRY(fields_open(&f, where, dim == 3 ? &looks : NULL));
    for (int k = 0; k < MOMENTS; k++) {
        struct cloud_frame frame = sample(dim, k);
        looks = sample_looks(k);
        frame.looks = dim == 3 ? &looks : NULL;
        TRY(fields_write(f, &frame));
    }
    fields_close(&f);
    return STATUS_DONE;
}

static void read_array(const char *name, const char *array, hid_t type, int rank, hsize_t columns,
                       void *to)
{
    const hid_t file = H5Fopen(output_path(name), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t set = H5Dopen2(file, array, H5P_DEFAULT), space = H5Dget_space(set);
    hsize_t size[2] = { 0, 1 };

    assert_true(file >= 0 && set >= 0);
    assert_int_equal(H5Sget_simple_extent_ndims(space), rank);
    H5Sget_simple_extent_dims(space, size, NULL);
    assert_int_equal(size[0], N);
    assert_int_equal(size[1], columns);
    assert_true(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, to) >= 0);
    H5Sclose(space);
    H5Dclose(set);
    H5Fclose(file);
}

/* The surface stands where it stood, and names what it has. */
static void check_bodies(void)
{
    const hid_t file = H5Fopen(output_path("fields/000002-bodies.vtkhdf"), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t points = H5Dopen2(file, "/VTKHDF/Points", H5P_DEFAULT);
    const hid_t mixed = H5Dopen2(file, "/XDMF/Mixed", H5P_DEFAULT);
    double x[4][3];
    int cell[20];

    assert_true(H5Dread(points, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, x) >= 0);
    assert_true(x[0][0] == 2 && x[1][0] == 5 && x[2][1] == 5 && x[3][2] == 5);
    assert_true(H5Dread(mixed, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, cell) >= 0);
    assert_true(cell[0] == 3 && cell[1] == 3 && cell[2] == 0 && cell[3] == 2 && cell[4] == 1);
    H5Dclose(points);
    H5Dclose(mixed);
    H5Fclose(file);
    assert_int_equal(output_count(output_contents("fields.xdmf"), "<Grid Name=\"bodies\""), MOMENTS);
    assert_int_equal(output_count(output_contents("fields.xdmf"), "<Time Value="), MOMENTS);
    assert_non_null(strstr(output_contents("fields.xdmf"), "Value=\"stone\""));
}

static void check_fields(int dim)
{
    static double x[N][3], p[N];
    static int id[N], kind[N];
    const struct cloud_frame frame = sample(dim, 2);

    assert_int_equal(output_write_sample(output_dir, dim), STATUS_DONE);
    read_array("fields/000002.vtkhdf", "/VTKHDF/Points", H5T_NATIVE_DOUBLE, 2, 3, x);
    read_array("fields/000002.vtkhdf", "/VTKHDF/PointData/pressure", H5T_NATIVE_DOUBLE, 1, 1, p);
    read_array("fields/000002.vtkhdf", "/VTKHDF/PointData/id", H5T_NATIVE_INT, 1, 1, id);
    read_array("fields/000002.vtkhdf", "/VTKHDF/PointData/kind", H5T_NATIVE_INT, 1, 1, kind);
    for (int i = 0; i < N; i++) {
        for (int d = 0; d < 3; d++)
            assert_true(x[i][d] == (d < dim ? frame.x[dim * i + d] : 0));
        assert_true(p[i] == frame.p[i] && id[i] == i && kind[i] == i % 5);
    }
    if (dim == 3)
        check_bodies();
    read_array("fields/000001.vtkhdf", "/VTKHDF/PointData/velocity", H5T_NATIVE_DOUBLE, 2, 3, x);
    assert_true(x[7][0] == 1 && x[7][1] == 8 && x[7][2] == (dim == 3 ? 15 : 0));
}

void test_fields_read_back(void **state)
{
    (void)state;
    check_fields(2);
    check_fields(3);
}

/* Whatever the index names is there, with the shape it says. */
void test_index_is_consistent(void **state)
{
    static double u[N][3];
    const char *index;

    (void)state;
    assert_int_equal(output_write_sample(output_dir, 2), STATUS_DONE);
    index = output_contents("fields.xdmf");
    assert_int_equal(output_count(index, "<Time Value="), MOMENTS);
    assert_int_equal(output_count(index, "<Topology "), MOMENTS);
    assert_int_equal(output_count(index, "NumberOfElements=\"30\""), MOMENTS);
    assert_int_equal(output_count(index, "<DataItem Dimensions=\"30 3\""), 2 * MOMENTS);
    assert_int_equal(output_count(index, "<DataItem Dimensions=\"30\""), 6 * MOMENTS);
    assert_non_null(strstr(index, "<Time Value=\"0.24"));
    assert_int_equal(output_count(index, "</Xdmf>"), 1);
    for (const char *s = index; (s = strstr(s, "Format=\"HDF\">")); s++) {
        char name[64], array[64];
        assert_int_equal(sscanf(s, "Format=\"HDF\">%63[^:]:%63[^<]", name, array), 2);
        read_array(name, array, H5T_NATIVE_DOUBLE,
                   strstr(array, "Points") || strstr(array, "velocity") ? 2 : 1,
                   strstr(array, "Points") || strstr(array, "velocity") ? 3 : 1, u);
    }
    assert_false(output_exists("fields.xdmf.part"));
}

/* A disk that fills up: STATUS_IO with path and reason, index and files stay whole. */
static int fields_fill_up(void)
{
    struct cloud_frame frame = sample(2, 0);
    struct rlimit most = { 1 << 20, 1 << 20 };
    struct fields *f;

    signal(SIGXFSZ, SIG_IGN);
    if (fields_open(&f, output_dir, NULL) != STATUS_DONE || fields_write(f, &frame) != STATUS_DONE)
        return 99;
    most.rlim_cur = most.rlim_max = 5000;
    if (setrlimit(RLIMIT_FSIZE, &most) != 0)
        return 98;
    frame.t = 1;
    if (fields_write(f, &frame) != STATUS_IO)
        return 97;
    fields_close(&f);
    return strstr(status_message(), "000001.vtkhdf") && strstr(status_message(), "File too large")
               ? 0
               : 96;
}

void test_fields_tell_of_a_full_disk(void **state)
{
    (void)state;
    assert_int_equal(output_child(fields_fill_up), 0);
    assert_int_equal(output_count(output_contents("fields.xdmf"), "<Time Value="), 1);
    assert_true(output_exists("fields/000000.vtkhdf"));
    assert_false(output_exists("fields/000001.vtkhdf"));
    assert_false(output_exists("fields/000001.vtkhdf.part"));
}

void test_snapshots(void **state)
{
    const struct cloud_frame frame[2] = { sample(2, 1), sample(3, 1) };
    struct snapshot *s;

    (void)state;
    for (int i = 0; i < 2; i++) {
        assert_int_equal(snapshot_open(&s, output_dir, false), STATUS_DONE);
        struct cloud_frame now = sample(i + 2, 1);
        assert_int_equal(snapshot_write(s, &now), STATUS_DONE);
        assert_string_equal(output_contents("snapshots.csv"),
                            "# units: s,\nt,file\n0.11,snapshots/0000.csv\n");
        now.t = frame[i].t + 1;
        assert_int_equal(snapshot_write(s, &now), STATUS_DONE);
        assert_int_equal(snapshot_close(&s), STATUS_DONE);
        assert_non_null(strstr(output_contents("snapshots.csv"), "\n1.11,snapshots/0001.csv\n"));
        assert_int_equal(output_count(output_contents("snapshots/0001.csv"), "\n"), N + 3);
        assert_non_null(strstr(output_contents("snapshots/0000.csv"),
                               i == 0 ? "x,y,ux,uy,rho,p,dye,kind\n0.5,100.5,1,1,1000,1,0,0\n"
                                      : "x,y,z,ux,uy,uz,rho,p,dye,kind\n"
                                        "0.5,100.5,200.5,1,1,1,1000,1,0,0\n1.5,101.5,201.5,1,2,3"));
    }
}
