/* output-figures.c -- unit tests: which figures are drawn, and what is said when they cannot be. */
#include "output.h"

#include "base/status.h"
#include "output/figures.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Scripts and a run for them: `good` applies, the needs of the others are missing. */
static void make_scripts(void)
{
    mkdir(output_path("plots"), 0777);
    mkdir(output_path("reference"), 0777);
    mkdir(output_path("run it's"), 0777);
    output_put("plots/helper.gp", "# helper.gp -- nothing to draw\nseen = 1\n");
    output_put("plots/good.gp", "# good.gp\n# needs: a.csv\n# reference: r.csv\nload 'helper.gp'\n"
                                "set print 'good.png'; print seen; print system('cat r.csv')\n");
    output_put("plots/norows.gp", "# needs: a.csv empty.csv\nset print 'norows.png'; print 1\n");
    output_put("plots/nofile.gp", "# needs: none.csv\nset print 'nofile.png'; print 1\n");
    output_put("reference/r.csv", "T,Z\n");
    output_put("run it's/a.csv", "# units: s\nt\n1\n");
    output_put("run it's/empty.csv", "# units: s\nt\n");
}

void test_figures(void **state)
{
    char run[256], plots[256];
    const char *path = getenv("PATH");

    (void)state;
    make_scripts();
    snprintf(run, sizeof run, "%s", output_path("run it's"));
    snprintf(plots, sizeof plots, "%s", output_path("plots"));
    if (system("gnuplot --version >/dev/null 2>&1") == 0) {
        assert_int_equal(figures_draw(run, plots, output_path("reference")), STATUS_DONE);
        assert_string_equal(output_contents("run it's/figures/good.png"), "1\nT,Z\n");
        assert_true(output_exists("run it's/figures/good.gp")
                    && output_exists("run it's/figures/r.csv"));
        assert_false(output_exists("run it's/figures/norows.png"));
        assert_false(output_exists("run it's/figures/nofile.png"));
        assert_false(output_exists("run it's/figures/good.gp.log"));
        output_put("plots/bad.gp", "# needs: a.csv\nplot nonsense(\n");
        remove(output_path("run it's/figures/good.png"));
        assert_int_equal(figures_draw(run, plots, output_path("reference")), STATUS_IO);
        assert_non_null(strstr(status_message(), "bad.gp"));
        assert_true(output_exists("run it's/figures/good.png")); /* drawn all the same */
        assert_true(output_exists("run it's/figures/bad.gp.log"));
        status_clear();
    }
    setenv("PATH", "/nowhere", 1);
    assert_int_equal(figures_draw(run, plots, output_path("reference")), STATUS_IO);
    setenv("PATH", path, 1);
    assert_non_null(strstr(status_message(), "gnuplot-nox"));
}

void test_constants(void **state)
{
    const struct figures_constants c = {
        .title = "Tóth's \"dam\"\n", .dim = 2, .a = NAN, .g = 9.81, .high = { 0.5, 0.25 },
        .beam_x = 0.3
    };

    (void)state;
    assert_int_equal(figures_constants(output_dir, &c), STATUS_DONE);
    assert_non_null(
        strstr(output_contents("figures/constants.gp"), "title = 'Tóth''s \"dam\" '\n"));
    assert_non_null(strstr(output_contents("figures/constants.gp"), "\na = NaN\n"));
    assert_non_null(strstr(output_contents("figures/constants.gp"), "\nhigh_y = 0.25\n"));
    assert_non_null(strstr(output_contents("figures/constants.gp"), "\nbeam_x = 0.2999"));
    assert_null(strstr(output_contents("figures/constants.gp"), "high_z"));
}
