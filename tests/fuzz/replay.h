/* replay.h -- the inputs that fuzzing has kept, each given to its target once, by any compiler. */
#ifndef FUZZ_REPLAY_H
#define FUZZ_REPLAY_H

/* Gives each file of tests/fuzz/corpus/NAME to LLVMFuzzerTestOneInput(), in a process of its own:
 * one that crashes hides no other.  Prints TAP; returns the exit status of the test. */
int replay(const char *name);

#endif
