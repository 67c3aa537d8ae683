/* dim.h -- for headers that only make sense in 2D or in 3D. */
#ifndef BASE_DIM_H
#define BASE_DIM_H

#if !defined(DIM) || (DIM != 2 && DIM != 3)
#error "this file is compiled with -DDIM=2 or -DDIM=3"
#endif

#endif
