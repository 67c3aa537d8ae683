/* commands.c -- the table of commands, a line each. */
#include "cli/commands.h"

#include <stddef.h>

static const struct argp_option run_options[] = {
    { "output", 'o', "DIR", 0, "Directory for the results (default: the scene's name)", 0 },
    { "method", 'm', "NAME", 0, "Time integration, see `stiffwater list methods`", 0 },
    { "tol", 't', "X", 0, "Error allowed in a step", 0 },
    { "until", 'u', "T", 0, "Time at which the run ends [s]", 0 },
    { "threads", 'n', "N", 0, "OpenMP threads (default: as many as make the run faster); the results do not "
      "depend on it", 0 },
    { "ranks", 'P', "N", 0, "Processes that share the run, by Open MPI's mpirun; the results do not "
      "depend on it", 0 },
    { "force", 'f', NULL, 0, "Take a directory with files that are no run's; they stay, unless they "
      "bear the names of a run's files", 0 },
    { "quiet", 'q', NULL, 0, "No progress line", 0 },
    { 0 },
};

static const struct argp_option resume_options[] = {
    { "until", 'u', "T", 0, "Time at which the run ends [s] (default: as it was to)", 0 },
    { "threads", 'n', "N", 0, "OpenMP threads (default: as many as make the run faster); the results do not "
      "depend on it", 0 },
    { "ranks", 'P', "N", 0, "Processes that share the run from here on, whatever their number was; "
      "the results do not depend on it", 0 },
    { "quiet", 'q', NULL, 0, "No progress line", 0 },
    { 0 },
};

static const struct argp_option compare_options[] = {
    { "methods", 'M', "A,B@CFL,...", 0,
      "Methods, see `stiffwater list methods`; those with a fixed rule take a CFL number", 0 },
    { "tols", 'T', "X,Y,...", 0,
      "Errors allowed in a step, each with each method that has an estimate "
      "(default: 1e-2,1e-3,1e-4)", 0 },
    { "sweep", 's', "KEY=V1,V2,...", 0, "Values of a key, each with all of that; again: all pairs",
      0 },
    { "until", 'u', "T", 0, "Time at which each run ends [s]", 0 },
    { "repeat", 'r', "N", 0, "Runs of each, for the median of CPU times and their range", 0 },
    { "budget", 'b', "SECONDS", 0, "A run that takes longer (by the clock) is stopped", 0 },
    { "jobs", 'j', "N", 0, "Runs at a time (default: 1)", 0 },
    { "threads", 'n', "N", 0, "OpenMP threads of each run (default: 1)", 0 },
    { "reference", 'R', "METHOD:TOL", 0,
      "The run that errors are taken against (default: bs54, with a beam imex4, at 1e-6 or a "
      "hundredth of the smallest of --tols); finest: for each the run with its method and the "
      "least value of --sweep spacing=...", 0 },
    { "early", 'e', "T", 0,
      "Time at which positions are compared [s] (default: free fall by ten spacings)", 0 },
    { "growth", 'g', NULL, 0,
      "Follows a tiny disturbance of the reference: until when do positions mean something?", 0 },
    { "output", 'o', "DIR", 0,
      "Directory for the results (default: the scene's name and -compare)", 0 },
    { "force", 'f', NULL, 0, "Take a directory with files of others; they stay, unless they bear the "
      "names of our own", 0 },
    { "quiet", 'q', NULL, 0, "No progress line, no table on the screen", 0 },
    { 0 },
};

static const struct argp_option sweep_options[] = {
    { "until", 'u', "T", 0, "Time at which each run ends [s]", 0 },
    { "method", 'm', "NAME", 0, "Time integration, see `stiffwater list methods`", 0 },
    { "tol", 't', "X", 0, "Error allowed in a step", 0 },
    { "budget", 'b', "SECONDS", 0, "A run that takes longer (by the clock) is stopped", 0 },
    { "jobs", 'j', "N", 0, "Runs at a time (default: 1)", 0 },
    { "threads", 'n', "N", 0, "OpenMP threads of each run (default: 1)", 0 },
    { "output", 'o', "DIR", 0,
      "Directory for the results (default: the scene's name and -sweep)", 0 },
    { "force", 'f', NULL, 0, "Take a directory with files of others; they stay, unless they bear the "
      "names of our own", 0 },
    { "quiet", 'q', NULL, 0, "No progress line, no table on the screen", 0 },
    { 0 },
};

static const struct argp_option spread_options[] = {
    { "runs", 'N', "N", 0, "Runs, 2 to 999 (default: 8)", 0 },
    { "size", 'd', "X", 0,
      "Largest shift of a particle of fluid at the start [spacings], 0 to 0.01 (default: 1e-6)",
      0 },
    { "seed", 'S', "N", 0, "Seed of the first run; the others count on from there (default: 1)",
      0 },
    { "window", 'w', "FROM,TO", 0, "Times between which peaks and means are taken [s] (default: all)", 0 },
    { "share", 'p', "X", 0,
      "A band this wide, in parts of the largest mean, ends what one run can tell; and particles "
      "this far apart [spacings] (default: 0.1)", 0 },
    { "method", 'm', "NAME", 0, "Time integration, see `stiffwater list methods`", 0 },
    { "tol", 't', "X", 0, "Error allowed in a step", 0 },
    { "until", 'u', "T", 0, "Time at which each run ends [s]", 0 },
    { "budget", 'b', "SECONDS", 0, "A run that takes longer (by the clock) is stopped", 0 },
    { "jobs", 'j', "N", 0, "Runs at a time (default: 1)", 0 },
    { "threads", 'n', "N", 0, "OpenMP threads of each run (default: 1)", 0 },
    { "output", 'o', "DIR", 0,
      "Directory for the results (default: the scene's name and -spread)", 0 },
    { "force", 'f', NULL, 0, "Take a directory with files of others; they stay, unless they bear the "
      "names of our own", 0 },
    { "quiet", 'q', NULL, 0, "No progress line, no table on the screen", 0 },
    { 0 },
};

static const struct argp_option hull_options[] = {
    { "scale", 'x', "X", 0, "Metres in one unit of the file: 0.001 for millimetres (default: 1)", 0 },
    { "merge", 'G', "LENGTH", 0, "Corners that are nearer than this are one [m] (default: 0)", 0 },
    { 0 },
};

static const struct argp_option no_options[] = { { 0 } };

const struct commands_row commands_table[] = {
    { "run", CLI_RUN, "SCENE [KEY=VALUE ...]",
      "Simulates a scene and leaves tables, particle fields and figures' data in a directory.\v"
      "Any key of the scene can be set: beam.E=5e9 sets E of every beam, beam.plate.E=5e9 of "
      "one.  Exit status: 0 done, 1 the run failed, 2 the scene or the command line is wrong, "
      "3 stopped by SIGINT, SIGTERM or SIGHUP (files are complete), 4 input or output failed.",
      run_options, true },
    { "resume", CLI_RESUME, "DIR [until=T]",
      "Goes on with a run that was interrupted, or makes one longer, from its last checkpoint.\v"
      "There is one when the scene sets output.checkpoint (simulated time) or "
      "output.checkpoint_minutes.  With the first, tables, fields and the last state are to the bit "
      "those of a run that was never interrupted; rows later than the checkpoint are cut off and "
      "written again.  A damaged checkpoint falls back to the one before.  Exit status: as of run.",
      resume_options, true },
    { "check", CLI_CHECK, "SCENE [KEY=VALUE ...]",
      "Prints the plan of a scene: parts, sizes, Mach number, expected steps, time, memory and disk. "
      "Simulates nothing, writes nothing.\v"
      "Warns of scenes that lead nowhere: no wall below the water, a probe inside a solid, a Mach "
      "number above 0.3; refuses those whose files the disk cannot hold or whose start has no "
      "right-hand side.  Shares of effects are measured, on scenes of up to 30,000 particles: what a "
      "right-hand side takes less without the effect.  With --ranks, memory of each rank and what a "
      "right-hand side sends, instead.  SCENE may be - for standard input.", run_options, true },
    { "plot", CLI_PLOT, "DIR",
      "Draws the figures of a run, comparison or spread again, by gnuplot.",
      no_options, false },
    { "report", CLI_REPORT, "DIR",
      "Writes DIR/report.html, one page with numbers, warnings, figures and scene of a run.\v"
      "All that it shows is in it, so that it opens without a network and can be sent.  Draws the "
      "figures first.  Each number stands beside what it is to be held against.  A comparison, "
      "sweep or spread has its words and figures.",
      no_options, false },
    { "movie", CLI_MOVIE, "DIR",
      "Makes a movie of the particle files of a run: DIR/movie.webm, or .gif without ffmpeg.\v"
      "A frame for each file in DIR/fields (scene key output.fields), drawn by gnuplot; the colour is "
      "the speed of the water; a 3D tank is cut in the middle.",
      no_options, false },
    { "hull", CLI_HULL, "FILE.stl",
      "Prints the points of the convex hull of a surface, for walls, fluids and bodies in 3D.\v"
      "STL in words or bytes.  What is printed stands in a scene as it is: `stiffwater hull boat.stl "
      ">boat.points`, and there body = { boat = { shape = \"hull\"; @include \"boat.points\" ... }; };  Dents "
      "are filled: make a body with dents of several.", hull_options, false },
    { "list", CLI_LIST, "TABLE",
      "Lists what there is: effects, kernels, eos, pressure, walls, bodies, flows or methods.",
      no_options, false },
    { "explain", CLI_EXPLAIN, "NAME",
      "Explains an effect, kernel, equation of state, wall model, body, group of keys, or a single key "
      "(tol, eos.gamma, beam.plate.E): "
      "equation, source, parameters with units and defaults.", no_options, false },
    { "compare", CLI_COMPARE, "SCENE [KEY=VALUE ...]",
      "Runs a scene with many methods and tolerances: one table and figures of what accuracy "
      "costs.\v"
      "Leaves compare.csv, a row for each run, those that failed included; compare.json, the "
      "reference; compare.md, the cheapest run for each accuracy; figures/work-precision.png; the "
      "runs themselves in runs/.  The same command again goes on where it was interrupted and "
      "runs only what is not there yet.", compare_options, true },
    { "sweep", CLI_SWEEP, "SCENE KEY=V1,V2,... [KEY=VALUE ...]",
      "Runs a scene with each value of a key, or each combination of several keys: what comes out "
      "against what was put in.\v"
      "A key with one value is set in all runs.  effects.NAME=on,off and wall.NAME=on,off show what "
      "an effect or an object changes and costs.  Leaves sweep.csv, a row for each run with its cost, "
      "the front at the end, peak forces and deflections, means of probes and more; sweep.md, "
      "which is printed too; figures/sweep-KEY.png; the runs themselves in runs/.  The same command "
      "again runs only what is not there yet.", sweep_options, true },
    { "spread", CLI_SPREAD, "SCENE [KEY=VALUE ...]",
      "Runs a scene many times from starts that differ by next to nothing: mean and band of "
      "front, forces, impulses, tips, probes.\v"
      "After an impact water is chaotic and a single run is one of many answers that are as right; "
      "this says from when on, and how far they lie apart.  Leaves spread.md, which is printed "
      "too; spread.csv, a row for each peak, its time, mean and end; spread-front.csv and its "
      "like, mean and band at each time; spread-positions.csv; spread.json; figures/spread-*.png; "
      "the runs themselves in runs/.  Runs that fail are left out, with a warning.  The same command "
      "again runs only what is not there yet; a larger --runs adds to it.", spread_options, true },
    { 0 },
};
