# mpi.sh -- for scripts that start ranks, which read it with `.` after lib.sh.
#
# Ranks share cores, so one that waits lets others work.  They are on one machine, where ways to others are not
# looked for (0.2 s a start), and write each other's memory by no call of the system, which some containers refuse.
OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_mpi_yield_when_idle=1
OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader OMP_NUM_THREADS=1
export OMPI_ALLOW_RUN_AS_ROOT OMPI_ALLOW_RUN_AS_ROOT_CONFIRM OMPI_MCA_mpi_yield_when_idle
export OMPI_MCA_btl_vader_single_copy_mechanism OMPI_MCA_pml OMPI_MCA_btl OMP_NUM_THREADS

# have_ranks: can there be any?
have_ranks() {
    [ -x "$top_builddir/stiffwater-2d-mpi" ] && { mpirun=$(command -v mpirun.openmpi) || mpirun=$(command -v mpirun); }
}

# need_ranks: skips the script where there can be none
need_ranks() {
    [ -x "$top_builddir/stiffwater-2d-mpi" ] || skip "configure found no Open MPI, or no Zoltan"
    have_ranks || skip "there is no mpirun"
}

# ranks N PROGRAM ARGUMENT...: its words go to $out/said, its status to $code; ended after $patience [s]
patience=120
ranks() {
    n=$1
    shift
    code=0
    timeout $patience "$mpirun" -q --oversubscribe --bind-to none -n "$n" "$@" >"$out/said" 2>&1 || code=$?
}
