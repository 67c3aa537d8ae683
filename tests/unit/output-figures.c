/* output-figures.c -- unit tests: which figures are drawn, and what is said when they cannot be. */
#include "output.h"

#include "base/status.h"
#include "output/figures-data.h"
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

/* What a user has changed stays, what we drew and do not draw any more goes. */
void test_figures_of_users(void **state)
{
    char run[256], plots[256];

    (void)state;
    if (system("gnuplot --version >/dev/null 2>&1") != 0)
        return;
    make_scripts();
    snprintf(run, sizeof run, "%s", output_path("run it's"));
    snprintf(plots, sizeof plots, "%s", output_path("plots"));
    mkdir(output_path("run it's/figures"), 0777);
    output_put("run it's/figures/good-mine.png", "a user's");
    output_put("plots/two.gp", "# needs: a.csv\nset print 'two-1.png'; print 1\n");
    assert_int_equal(figures_draw(run, plots, output_path("reference")), STATUS_DONE);
    assert_string_equal(output_contents("run it's/figures/two-1.png"), "1\n");
    output_put("run it's/figures/good.gp", "set print 'good.png'; print 'changed'\n");
    output_put("run it's/figures/helper.gp", "system('touch ../touched')\n");
    output_put("run it's/figures/good.png", "drawn by hand");
    output_put("plots/two.gp", "# needs: a.csv\nset print 'two-2.png'; print 2\n");
    assert_int_equal(figures_draw(run, plots, output_path("reference")), STATUS_DONE);
    assert_false(output_exists("run it's/touched"));
    assert_string_equal(output_contents("run it's/figures/good.gp.mine"),
                        "set print 'good.png'; print 'changed'\n");
    assert_string_equal(output_contents("run it's/figures/good.png.mine"), "drawn by hand");
    assert_string_equal(output_contents("run it's/figures/good.png"), "1\nT,Z\n");
    assert_string_equal(output_contents("run it's/figures/good-mine.png"), "a user's");
    assert_false(output_exists("run it's/figures/two-1.png"));
    assert_true(output_exists("run it's/figures/two-2.png"));
    output_put("run it's/figures/good.gp", "again\n");
    assert_int_equal(figures_draw(run, plots, output_path("reference")), STATUS_DONE);
    assert_string_equal(output_contents("run it's/figures/good.gp.mine-2"), "again\n");
    remove(output_path("plots/two.gp"));
}

/* Constants are never carried out. */
void test_constants_of_strangers(void **state)
{
    static const char *const bad[] = {
        "a = system(\"touch touched\")", "system('touch touched')", "a = `touch touched`",
        "t = \"`touch touched`\"", "t = 'a'.system('touch touched').'b'", "a = 1; system('true')",
        "t = \"a\" . system(\"true\")", "a = 1 b", "a=1", "= 1", "1 = 1", "t = \"a", "t = \"\\9\"",
        "t = \"@b\"", "a = 0x10", "a = inf",
    };
    char from[256], to[256];

    (void)state;
    snprintf(from, sizeof from, "%s", output_path("from.gp"));
    snprintf(to, sizeof to, "%s", output_path("to.gp"));
    output_put("from.gp", "# of a run\na = -1.5e-07\nn2 = NaN\ntitle = \"A \\047b\\047, 2: (c)\"\n");
    assert_int_equal(figures_data_copy(from, to), STATUS_DONE);
    assert_string_equal(output_contents("to.gp"),
                        "a = -1.5e-07\nn2 = NaN\ntitle = \"A \\047b\\047, 2: (c)\"\n");
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        char line[200];
        snprintf(line, sizeof line, "a = 1\n%s\n", bad[i]);
        output_put("from.gp", line);
        if (figures_data_copy(from, to) != STATUS_IO)
            fail_msg("%s is taken for a constant", bad[i]);
        assert_non_null(strstr(status_message(), "from.gp:2: this line is no constant"));
        status_clear();
    }
    assert_string_equal(output_contents("to.gp"),
                        "a = -1.5e-07\nn2 = NaN\ntitle = \"A \\047b\\047, 2: (c)\"\n");
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
        strstr(output_contents("figures/constants.gp"), "title = \"Tóth\\047s \\042dam\\042\\040\"\n"));
    assert_non_null(strstr(output_contents("figures/constants.gp"), "\na = NaN\n"));
    assert_non_null(strstr(output_contents("figures/constants.gp"), "\nhigh_y = 0.25\n"));
    assert_non_null(strstr(output_contents("figures/constants.gp"), "\nbeam_x = 0.2999"));
    assert_null(strstr(output_contents("figures/constants.gp"), "high_z"));
}
