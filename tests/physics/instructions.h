/* instructions.h -- counts instructions of any machine code, eight lanes included, which
 * valgrind does not know and for which virtual machines offer no counters. */
#ifndef TESTS_PHYSICS_INSTRUCTIONS_H
#define TESTS_PHYSICS_INSTRUCTIONS_H

/* Instructions of work(with) in a copy of this process that is traced step by step, so that
 * nothing it does is seen here; those of libgomp and libc are not counted.  Some 20,000 a
 * second in a virtual machine.  -1 where processes may not be traced.  The process must have one thread. */
long instructions_of(void (*work)(void *with), void *with);

#endif
