/* output.h -- a directory for each test of the room output, and looks into its files. */
#ifndef UNIT_OUTPUT_H
#define UNIT_OUTPUT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

extern char output_dir[64]; /* of this test, removed after it */

int output_make_dir(void **state);
int output_remove_dir(void **state);
#define OUTPUT_TEST(function) \
    cmocka_unit_test_setup_teardown(function, output_make_dir, output_remove_dir)

/* "DIR/NAME", good until the fourth call after this one. */
const char *output_path(const char *name);

/* Everything in a file, "" when there is none; until the next call. */
const char *output_contents(const char *name);
void output_put(const char *name, const char *text);
int output_exists(const char *name);

int output_count(const char *text, const char *what); /* how often what stands in text */

/* Runs work() in a child: what it returns, or 1000 + the signal that ended it. */
int output_child(int (*work)(void));

/* output-fields.c, output-figures.c */
int output_write_sample(const char *dir, int dim);
void test_fields_read_back(void **state);
void test_index_is_consistent(void **state);
void test_fields_tell_of_a_full_disk(void **state);
void test_snapshots(void **state);
void test_figures(void **state);
void test_figures_of_users(void **state);
void test_constants_of_strangers(void **state);
void test_constants(void **state);

#endif
