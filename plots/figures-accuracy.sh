#!/bin/sh
# figures-accuracy.sh -- what accuracy costs: compares the methods on shipped scenes and draws
# DIR/accuracy-*.png, which doc/accuracy.md tells of.
#
# Run by `make figures', or by hand in a build tree:
#
#     top_srcdir=PATH sh .../figures-accuracy.sh DIR [COMPARISON...]
#
# Runs, tables (compare.csv, compare.md) and all figures stay in DIR/accuracy/; the same command
# again makes only what is missing, and with names of comparisons only those.  About six CPU
# minutes; times mean something on a machine that does nothing else.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
mkdir -p "$1/accuracy"
cd "$1/accuracy"
shift
wanted=$*

# those WORD...: of these methods the ones that the SUNDIALS at hand has, with commas
known=$("$stiffwater" list methods)
those()
{
    for word; do
        if echo "$known" | grep -q "^${word%%@*} "; then printf '%s,' "$word"; fi
    done | sed 's/,$//'
}

# compare NAME SCENE WORD...: into NAME/, unless other comparisons are wanted
compare()
{
    name=$1
    scene=$2
    shift 2
    case " ${wanted:-$name} " in *" $name "*) ;; *) return 0 ;; esac
    echo "figures-accuracy: $name"
    "$stiffwater" compare "$top/data/scenes/$scene.scene" -o "$name" "$@" >"$name.said" 2>&1 ||
        { cat "$name.said" >&2; exit 1; }
}

# show NAME FIGURE AS: a figure of a comparison is one of the documentation's
show()
{
    if [ -f "$1/figures/$2.png" ]; then
        cp "$1/figures/$2.png" "../accuracy-$3.png"
    fi
}

# --- a dam break while it is smooth: 1,800 particles, falling, no wall reached yet ----------
smooth=$(those cks43 bs54 opt53 opt64 ark436 erk2 erk3 erk4 erk5 erk6 ab3 adams bdf gsl-msadams \
    gsl-rkf45 gsl-rk8pd dv leapfrog@0.5 leapfrog@0.25 leapfrog@0.1 leapfrog@0.05 leapfrog@0.025 \
    euler-cfl@0.25 staggered@0.25)
compare smooth dam-break spacing=3.3333333333333333e-3 --until 0.1 --budget 20 \
    --methods "$smooth" --tols 1e-1,1e-2,1e-3,1e-4,1e-5,1e-6 \
    --reference ARKODE_FEHLBERG_13_7_8:1e-10
show smooth work-precision-position position
show smooth work-precision-front front
show smooth work-precision-impulse impulse
show smooth work-precision-energy energy

# --- the whole second, with the impacts: 800 particles --------------------------------------
compare second dam-break spacing=5e-3 --until 1 --budget 30 --growth \
    --methods "$(those cks43 bs54 opt53 opt64 ark436 erk4 ab3 adams gsl-rkf45 dv leapfrog@0.4 \
        leapfrog@0.25 leapfrog@0.1 euler-cfl@0.25 staggered@0.25)" \
    --tols 1e-1,1e-2,1e-3 --reference ARKODE_FEHLBERG_13_7_8:1e-7
show second work-precision second
show second step-lengths steps

# --- with a beam: 200 particles, 10 elements -----------------------------------------------
beam='spacing=0.01 beam.elements=10'
implicit='imex2 imex3 imex4 imex5 dv'
# shellcheck disable=SC2086 # lists of words
compare beam toth-beam $beam --until 0.3 --budget 60 \
    --methods "$(those $implicit bdf mri@0.25 mri@0.5 mri@1 staggered@0.25 staggered@0.1 \
        cks43@2e-6s leapfrog@0.25)" --tols 1e-1,1e-2,1e-3,1e-4,1e-5 --reference cks43:1e-5
show beam work-precision beam
show beam step-lengths beam-steps

# --- what stiffness costs: the water leans on the beam from the start ------------------------
# shellcheck disable=SC2086
{
stiff="$beam beam.at=[0.115,0] --until 0.05 --budget 5 --tols 1e-2"
stiff="$stiff --methods $(those $implicit mri@0.5 staggered@0.25 cks43 leapfrog@0.25)"
compare stiffness toth-beam $stiff --sweep beam.E=0.05e9,0.5e9,5e9,50e9,210e9
compare elements toth-beam $stiff --sweep beam.elements=10,20,30,50,100
}
show stiffness cost-against-beam.E stiffness
show elements cost-against-beam.elements elements

# --- the beam without water ------------------------------------------------------------------
alone="imex3 imex4 imex5 dirk2 dirk3 dirk4 dirk5 dv staggered@0.25 cks43"
# shellcheck disable=SC2086
{
compare alone-stiffness beam-alone --until 0.01 --budget 2 --tols 1e-2,1e-4 \
    --methods "$(those $alone)" --sweep beam.E=0.05e9,0.5e9,5e9,50e9,210e9
compare alone-elements beam-alone --until 0.01 --budget 2 --tols 1e-2,1e-4 \
    --methods "$(those $alone)" --sweep beam.elements=10,20,30,50,100
}
show alone-stiffness cost-against-beam.E alone-stiffness
show alone-elements cost-against-beam.elements alone-elements
