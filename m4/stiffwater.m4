# stiffwater.m4 -- the longer tests of configure.ac.  Every failure names the Debian package to install.

# SW_PKG(PREFIX, MODULE, VERSION, DEBIAN-PACKAGE)
# A library with a pkg-config file; sets PREFIX_CFLAGS, PREFIX_LIBS, PREFIX_version.
AC_DEFUN([SW_PKG], [
  PKG_CHECK_MODULES([$1], [$2 >= $3], [],
    [AC_MSG_ERROR([$2 $3 or newer is missing. On Debian: apt-get install $4])])
  $1[]_version=`$PKG_CONFIG --modversion $2`
])

# SW_FLAGS
# Sorts compiler flags into OPT_CFLAGS (all code), HOT_CFLAGS (the pair engine)
# and SANITIZER_FLAGS, and refuses those that would make results wrong.
AC_DEFUN([SW_FLAGS], [
  AC_ARG_ENABLE([debug],
    [AS_HELP_STRING([--enable-debug], [compile everything with -Og, also the pair engine])],
    [], [enable_debug=no])
  AC_ARG_ENABLE([sanitizer],
    [AS_HELP_STRING([--enable-sanitizer@<:@=LIST@:>@],
      [run-time checks of gcc or clang @<:@address,undefined@:>@])],
    [], [enable_sanitizer=no])
  SW_REFUSE_FAST_MATH
  SW_CHECK_C17
  SW_SPLIT_OPTIMISATION
  SW_SANITIZER
])

# Flags after which NaN, or the order of a sum, is no longer what the source says.
AC_DEFUN([SW_REFUSE_FAST_MATH], [
  for flag in $CC $CPPFLAGS $CFLAGS; do
    AS_CASE([$flag],
      [-ffast-math|-Ofast|-ffinite-math-only|-funsafe-math-optimizations],
        [AC_MSG_ERROR([$flag lets the compiler assume that no number is NaN.
  NaN is how a right-hand side tells the integrator that it has no answer, so runs
  would go on with rubbish. Take $flag out of CFLAGS; the pair engine gets the safe
  half of it (-O3 -fno-math-errno -fno-trapping-math) by itself.])],
      [-fassociative-math|-freciprocal-math|-ffp-contract=fast|-ffp-contract=on],
        [AC_MSG_ERROR([$flag lets the compiler round sums its own way.
  Results would then depend on the compiler and the machine, and the tests that compare
  bits would fail. Take $flag out of CFLAGS.])])
  done
])

AC_DEFUN([SW_CHECK_C17], [
  AC_CACHE_CHECK([whether $CC knows C17], [sw_cv_c17],
    [sw_save=$CFLAGS
    CFLAGS="$CFLAGS -std=gnu17"
    AC_COMPILE_IFELSE([AC_LANG_PROGRAM([_Static_assert(__STDC_VERSION__ >= 201710L, "C17");])],
      [sw_cv_c17=yes], [sw_cv_c17=no])
    CFLAGS=$sw_save])
  AS_IF([test $sw_cv_c17 = no],
    [AC_MSG_ERROR([$CC does not know -std=gnu17: gcc 8 or clang 7 is the least.
  On Debian: apt-get install gcc])])
])

# automake puts CFLAGS last, so an -O2 in it would undo the -O3 of the pair engine.
# Therefore -O is taken out of CFLAGS and put where it belongs: -O0, -O1, -Og for all
# code (somebody debugs), any other for all but the pair engine.
AC_DEFUN([SW_SPLIT_OPTIMISATION], [
  OPT_CFLAGS=-O2
  AS_IF([test "$enable_debug" != no], [OPT_CFLAGS=-Og])
  sw_rest=
  for flag in $CFLAGS; do
    AS_CASE([$flag], [-O*], [OPT_CFLAGS=$flag], [sw_rest="$sw_rest $flag"])
  done
  CFLAGS=${sw_rest# }
  AS_CASE([$OPT_CFLAGS], [-O0|-O1|-O|-Og], [HOT_CFLAGS=$OPT_CFLAGS], [HOT_CFLAGS=-O3])
  AC_SUBST([OPT_CFLAGS])
  AC_SUBST([HOT_CFLAGS])
])

AC_DEFUN([SW_SANITIZER], [
  AS_IF([test "$enable_sanitizer" = yes], [enable_sanitizer=address,undefined])
  SANITIZER_FLAGS=
  AS_IF([test "$enable_sanitizer" != no], [
    SANITIZER_FLAGS="-fsanitize=$enable_sanitizer -fno-omit-frame-pointer"
    AS_CASE([$enable_sanitizer], [*undefined*],
      [SANITIZER_FLAGS="$SANITIZER_FLAGS -fno-sanitize-recover=undefined"])
    AC_MSG_CHECKING([whether $CC links with $SANITIZER_FLAGS])
    sw_save=$CFLAGS
    CFLAGS="$CFLAGS $SANITIZER_FLAGS"
    AC_LINK_IFELSE([AC_LANG_PROGRAM()], [AC_MSG_RESULT([yes])], [AC_MSG_RESULT([no])
      AC_MSG_ERROR([--enable-sanitizer=$enable_sanitizer does not link.
  On Debian: apt-get install gcc libc6-dev])])
    CFLAGS=$sw_save
  ])
  AC_SUBST([SANITIZER_FLAGS])
])

# SW_V3
# Can we make 4-lane code (AVX2, FMA), and ask the machine at run time whether it may
# be used?  V3_CPPFLAGS is -DSTIFFWATER_V3=1 when __builtin_cpu_supports() knows
# "x86-64-v3", -DSTIFFWATER_V3=2 when it must be asked for "avx2" and "fma".
AC_DEFUN([SW_V3], [
  AC_CACHE_CHECK([for x86-64-v3 (4 lanes), chosen at run time], [sw_cv_v3],
    [sw_cv_v3=no
    sw_save=$CFLAGS
    CFLAGS="$CFLAGS -march=x86-64-v3"
    AC_COMPILE_IFELSE([AC_LANG_PROGRAM()], [sw_march=yes], [sw_march=no])
    CFLAGS=$sw_save
    AS_IF([test $sw_march = yes],
      [AC_LINK_IFELSE([AC_LANG_PROGRAM([], [return !__builtin_cpu_supports("x86-64-v3");])],
        [sw_cv_v3=1],
        [AC_LINK_IFELSE([AC_LANG_PROGRAM([],
          [return !(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"));])],
          [sw_cv_v3=2])])])])
  V3_CPPFLAGS=
  AS_IF([test $sw_cv_v3 != no], [V3_CPPFLAGS=-DSTIFFWATER_V3=$sw_cv_v3])
  AC_SUBST([V3_CPPFLAGS])
  AM_CONDITIONAL([HAVE_V3], [test $sw_cv_v3 != no])
])

# SW_V4
# The same for 8 lanes (AVX-512); V4_CPPFLAGS is -DSTIFFWATER_V4 where 4 lanes are possible, too.
AC_DEFUN([SW_V4], [
  AC_REQUIRE([SW_V3])
  AC_CACHE_CHECK([for x86-64-v4 (8 lanes), chosen at run time], [sw_cv_v4],
    [sw_cv_v4=no
    sw_save=$CFLAGS
    CFLAGS="$CFLAGS -march=x86-64-v4 -mprefer-vector-width=512"
    AC_COMPILE_IFELSE([AC_LANG_PROGRAM()], [sw_march=yes], [sw_march=no])
    CFLAGS=$sw_save
    AS_IF([test $sw_march = yes && test $sw_cv_v3 != no],
      [AC_LINK_IFELSE([AC_LANG_PROGRAM([], [return !__builtin_cpu_supports("x86-64-v4");])],
        [sw_cv_v4=yes])])])
  V4_CPPFLAGS=
  AS_IF([test $sw_cv_v4 = yes], [V4_CPPFLAGS=-DSTIFFWATER_V4])
  AC_SUBST([V4_CPPFLAGS])
  AM_CONDITIONAL([HAVE_V4], [test $sw_cv_v4 = yes])
])

# SW_TRY_LINK(CFLAGS, LIBS, PROLOGUE, BODY, IF-YES, IF-NO)
AC_DEFUN([SW_TRY_LINK], [
  sw_save_CFLAGS=$CFLAGS sw_save_LIBS=$LIBS
  CFLAGS="$CFLAGS $1" LIBS="$2 $LIBS"
  AC_LINK_IFELSE([AC_LANG_PROGRAM([$3], [$4])], [sw_linked=yes], [sw_linked=no])
  CFLAGS=$sw_save_CFLAGS LIBS=$sw_save_LIBS
  AS_IF([test $sw_linked = yes], [$5], [$6])
])

# SW_HDF5
# Debian calls the flavour without MPI hdf5-serial; plain hdf5 may be the one with MPI,
# so whatever pkg-config answers must also link.
AC_DEFUN([SW_HDF5], [
  PKG_CHECK_MODULES([HDF5], [hdf5-serial],
    [HDF5_version=`$PKG_CONFIG --modversion hdf5-serial`],
    [PKG_CHECK_MODULES([HDF5], [hdf5],
      [HDF5_version=`$PKG_CONFIG --modversion hdf5`],
      [HDF5_CFLAGS= HDF5_LIBS=-lhdf5 HDF5_version=found])])
  AC_MSG_CHECKING([whether HDF5 links])
  SW_TRY_LINK([$HDF5_CFLAGS], [$HDF5_LIBS], [#include <hdf5.h>], [return H5open() < 0;],
    [AC_MSG_RESULT([yes])],
    [AC_MSG_RESULT([no])
    AC_MSG_ERROR([HDF5 (C, without MPI) is missing. On Debian: apt-get install libhdf5-dev])])
])

# SW_SUNDIALS
# No pkg-config file on Debian, so it is probed by linking.  7.x keeps its core in
# sundials_core, 6.x in sundials_generic; a 7.x built with MPI needs MPI's flags too.
AC_DEFUN([SW_SUNDIALS], [
  sw_where="On Debian: apt-get install libsundials-dev
  One of your own: ./configure CPPFLAGS=-I<prefix>/include LDFLAGS=\"-L<prefix>/lib -Wl,-rpath,<prefix>/lib\""
  AC_MSG_CHECKING([for SUNDIALS 6.4 or newer])
  for part in MAJOR MINOR PATCH; do
    AC_COMPUTE_INT([sw_number], [SUNDIALS_VERSION_$part],
      [#include <sundials/sundials_config.h>], [sw_number=missing])
    AS_IF([test $sw_number = missing], [AC_MSG_RESULT([no])
      AC_MSG_ERROR([SUNDIALS is missing (no sundials/sundials_config.h). $sw_where])])
    AS_VAR_SET([sundials_$part], [$sw_number])
  done
  SUNDIALS_version=$sundials_MAJOR.$sundials_MINOR.$sundials_PATCH
  AC_MSG_RESULT([$SUNDIALS_version])
  AS_IF([test `expr $sundials_MAJOR \* 1000 + $sundials_MINOR` -lt 6004],
    [AC_MSG_ERROR([SUNDIALS $SUNDIALS_version is too old: 6.4 is the first that works
  (Debian 12 has 6.4.1). $sw_where])])
  SW_SUNDIALS_LINK
  AC_SUBST([SUNDIALS_CFLAGS])
  AC_SUBST([SUNDIALS_LIBS])
])

AC_DEFUN([SW_SUNDIALS_LINK], [
  AS_IF([test $sundials_MAJOR -ge 7], [sw_core=-lsundials_core], [sw_core=-lsundials_generic])
  SUNDIALS_CFLAGS=
  SUNDIALS_LIBS="-lsundials_arkode -lsundials_cvode -lsundials_nvecserial dnl
-lsundials_sunnonlinsolnewton -lsundials_sunnonlinsolfixedpoint -lsundials_sunlinsolspgmr dnl
-lsundials_sunlinsolpcg $sw_core"
  sundials_mpi=no
  AC_MSG_CHECKING([whether SUNDIALS links])
  SW_SUNDIALS_TRY([AC_MSG_RESULT([yes])], [
    AC_MSG_RESULT([not by itself])
    PKG_CHECK_MODULES([MPI], [ompi-c], [sundials_mpi=yes],
      [PKG_CHECK_MODULES([MPI], [mpich], [sundials_mpi=yes], [MPI_CFLAGS= MPI_LIBS=])])
    SUNDIALS_CFLAGS=$MPI_CFLAGS
    SUNDIALS_LIBS="$SUNDIALS_LIBS $MPI_LIBS"
    AC_MSG_CHECKING([whether SUNDIALS links with MPI])
    SW_SUNDIALS_TRY([AC_MSG_RESULT([yes])], [AC_MSG_RESULT([no])
      AC_MSG_ERROR([SUNDIALS $SUNDIALS_version is there but does not link (see config.log).
  If it was built with MPI: apt-get install libopenmpi-dev. $sw_where])])])
])

AC_DEFUN([SW_SUNDIALS_TRY], [
  SW_TRY_LINK([$SUNDIALS_CFLAGS], [$SUNDIALS_LIBS],
    [#include <arkode/arkode_arkstep.h>
    #include <cvode/cvode.h>
    #include <nvector/nvector_serial.h>
    #include <sunnonlinsol/sunnonlinsol_newton.h>
    #include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
    #include <sunlinsol/sunlinsol_spgmr.h>],
    [SUNContext context;
    SUNContext_Create(0, &context);
    N_Vector y = N_VNew_Serial(1, context);
    SUNNonlinSol_Newton(y, context);
    SUNNonlinSol_FixedPoint(y, 0, context);
    SUNLinSol_SPGMR(y, 0, 0, context);
    CVodeCreate(CV_ADAMS, context);
    return !ARKStepCreate(0, 0, 0, y, context);],
    [$1], [$2])
])

# SW_MPI
# The programs for many machines are built where Open MPI and Zoltan are.  Another MPI is no use:
# Debian's Zoltan is built with Open MPI, and two of them in one program run whole copies of it.
AC_DEFUN([SW_MPI], [
  AC_ARG_WITH([mpi],
    [AS_HELP_STRING([--with-mpi], [programs for many machines, with Open MPI and Zoltan
      @<:@where both are found@:>@])],
    [], [with_mpi=maybe])
  have_mpi=no
  AS_IF([test "$with_mpi" != no], [
    PKG_CHECK_MODULES([OMPI], [ompi-c], [sw_mpi_lacks=], [sw_mpi_lacks="Open MPI"])
    AS_IF([test -z "$sw_mpi_lacks"], [SW_ZOLTAN])
    AS_IF([test -z "$sw_mpi_lacks"], [have_mpi=yes],
      [SW_MPI_LACKS])])
  AM_CONDITIONAL([HAVE_MPI], [test $have_mpi = yes])
  have_hypre=no
  AS_IF([test $have_mpi = yes], [SW_HYPRE])
  AM_CONDITIONAL([HAVE_HYPRE], [test $have_hypre = yes])
  AC_PATH_PROGS([MPIRUN], [mpirun.openmpi mpirun], [no])
])

AC_DEFUN([SW_HYPRE], [
  AC_ARG_WITH([hypre],
    [AS_HELP_STRING([--without-hypre], [no multigrid for the method mps
      @<:@with it where HYPRE is found@:>@])],
    [], [with_hypre=maybe])
  HYPRE_CFLAGS="-isystem /usr/include/hypre" HYPRE_LIBS=-lHYPRE
  AS_IF([test "$with_hypre" != no], [
    AC_MSG_CHECKING([for HYPRE with Open MPI])
    SW_TRY_LINK([$OMPI_CFLAGS $HYPRE_CFLAGS], [$HYPRE_LIBS $OMPI_LIBS],
      [#include <HYPRE_parcsr_ls.h>
      #ifdef HYPRE_USING_OPENMP
      #error sums that depend on the number of threads
      #endif],
      [HYPRE_Solver solver;
      HYPRE_Init();
      return HYPRE_BoomerAMGCreate(&solver);],
      [have_hypre=yes])
    AC_MSG_RESULT([$have_hypre])
    AS_IF([test $have_hypre = no && test "$with_hypre" = yes], [AC_MSG_ERROR([HYPRE is missing, or is one
  with OpenMP, whose bits depend on the number of threads. On Debian: apt-get install libhypre-dev])])])
  AS_IF([test $have_hypre = no], [HYPRE_CFLAGS= HYPRE_LIBS=])
  AC_SUBST([HYPRE_CFLAGS])
  AC_SUBST([HYPRE_LIBS])
])
AC_DEFUN([SW_MPI_LACKS], [
  sw_mpi_says="$sw_mpi_lacks is missing, which programs for many machines need.
  On Debian: apt-get install libopenmpi-dev openmpi-bin libtrilinos-zoltan-dev"
  PKG_CHECK_EXISTS([mpich], [sw_mpi_says="$sw_mpi_says
  (MPICH is there, but will not do: Zoltan is built with Open MPI.)"])
  AS_IF([test "$with_mpi" = yes], [AC_MSG_ERROR([$sw_mpi_says])])
])

# Debian has its header in trilinos/ and the library under a name of its own.
AC_DEFUN([SW_ZOLTAN], [
  AC_MSG_CHECKING([for Zoltan with Open MPI])
  sw_mpi_lacks="Zoltan (for Open MPI)"
  for sw_zoltan in trilinos_zoltan zoltan; do
    AS_IF([test -n "$sw_mpi_lacks"], [
      ZOLTAN_CFLAGS="-isystem /usr/include/trilinos" ZOLTAN_LIBS=-l$sw_zoltan
      SW_TRY_LINK([$OMPI_CFLAGS $ZOLTAN_CFLAGS], [$ZOLTAN_LIBS $OMPI_LIBS],
        [#include <mpi.h>
        #include <zoltan.h>
        #ifndef OPEN_MPI
        #error another MPI
        #endif],
        [float version;
        MPI_Init(0, 0);
        return Zoltan_Initialize(0, 0, &version);],
        [sw_mpi_lacks=])])
  done
  AS_IF([test -z "$sw_mpi_lacks"], [AC_MSG_RESULT([$ZOLTAN_LIBS])], [AC_MSG_RESULT([no])])
  AC_SUBST([ZOLTAN_CFLAGS])
  AC_SUBST([ZOLTAN_LIBS])
])

# SW_SUMMARY
# What was found, and what to type next.
AC_DEFUN([SW_SUMMARY], [
  AS_IF([test $sw_cv_v3 = no], [sw_lanes="2"],
        [test $sw_cv_v4 = no], [sw_lanes="2, and 4 where the machine has AVX2"],
        [sw_lanes="2, 4 where the machine has AVX2, 8 where it has AVX-512"])
  AS_IF([test -z "$OPENMP_CFLAGS"], [sw_openmp="no (one core only)"], [sw_openmp="yes"])
  AS_IF([test $sundials_mpi = yes], [sw_mpi=" (with MPI)"], [sw_mpi=])
  AS_IF([test $have_mpi = yes], [sw_ranks="Open MPI, Zoltan"],
    [sw_ranks="no (Open MPI and Zoltan are needed)"])
  AS_IF([test $have_hypre = yes], [sw_multigrid=HYPRE],
    [test $have_mpi = yes], [sw_multigrid="no (on Debian: apt-get install libhypre-dev)"],
    [sw_multigrid="no (HYPRE and many ranks are needed)"])
  AS_IF([test $have_cmocka = no], [sw_tests="no cmocka: make check will not build"],
    [sw_tests="yes"])
  AS_IF([test "$GNUPLOT" = no], [sw_gnuplot="no (no figures until it is installed)"],
    [sw_gnuplot=$GNUPLOT])
  cat <<_SUMMARY

Stiffwater $PACKAGE_VERSION
  compiler    $CC $OPT_CFLAGS, pair engine $HOT_CFLAGS, yours: $CFLAGS
  SUNDIALS    $SUNDIALS_version$sw_mpi
  GSL         $GSL_version
  Qhull       $QHULL_version
  HDF5        $HDF5_version
  lanes       $sw_lanes
  OpenMP      $sw_openmp
  sanitizer   $enable_sanitizer
  many ranks  $sw_ranks
  multigrid   $sw_multigrid
  tests       $sw_tests
  gnuplot     $sw_gnuplot
  prefix      $prefix

Now: make, make check, make install.

_SUMMARY
])

# SW_DEPENDENCIES -- makes the files in which the compiler will note what an object depends on.
# Automake's own command, which comes next and finds them there, starts some shells for each of
# two thousand: that took five times as long as all else that configure does.
# Stands before AM_INIT_AUTOMAKE, so that its command does.
AC_DEFUN([SW_DEPENDENCIES],
[AC_CONFIG_COMMANDS([dependencies],
  [AS_IF([test -z "$sw_track"],
    [sw_deps=`sed -n 's/^DEPDIR = //p' Makefile`
     sed -n '/^am__depfiles_remade = /,/@<:@^\\@:>@$/p' Makefile | tr ' \\\\' '\n\n' |
       sed -n "s,\\\$(DEPDIR),$sw_deps,;/\.Po\$/p" >conf$$.deps
     sed 's,/@<:@^/@:>@*$,,' conf$$.deps | sort -u | xargs mkdir -p
     xargs touch <conf$$.deps
     rm -f conf$$.deps])],
  [sw_track=$AMDEP_TRUE])])
