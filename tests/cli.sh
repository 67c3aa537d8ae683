#!/bin/sh
# cli.sh -- the command line keeps its word: help, tables, exit status, and what is left
# behind when a run is stopped or cannot write.  Run by `make check`.
scenes=${top_srcdir:-.}/tests/scenes
ask=
. "${top_srcdir:-.}/tests/lib.sh"
asking

# --- help and versions --------------------------------------------------------------------
commands='run resume check plot report movie hull list explain compare sweep spread'
for word in --help -h help; do
    expect 0 $word
    # shellcheck disable=SC2086 # one pattern a command
    says $commands movie.webm, KEY=V1,V2,...
done
for command in $commands; do
    expect 0 "$command" --help
    says "$command" Usage
done
expect 0 --version
says stiffwater SUNDIALS GSL HDF5 OpenMP
expect 0 -V

# --- tables ---------------------------------------------------------------------------------
for table in effects kernels eos pressure walls bodies flows methods; do
    expect 0 list $table
    [ -s said ] || complain "list $table is empty"
    cp said "table.$table"
done
grep -q '^continuity ' table.effects || complain "list effects lacks continuity"
for table in effects kernels eos walls bodies; do
    for name in $(awk '{ print $1 }' table.$table); do
        expect 0 explain "$name"
        says "$name"
        [ "$(wc -l <said)" -ge 2 ] || complain "explain $name says too little"
    done
done
for name in $(awk '$1 !~ /\.\.\.$/ { print $1 }' table.methods); do
    case $name in # these take no beam, and say which methods do
    adams | gsl-* | mps | mri-rigid)
        expect 2 check "$scenes/small-2d.scene" --method "$name"
        says beam imex3
        continue ;;
    dirk*) # these take no water
        expect 2 check "$scenes/small-2d.scene" --method "$name"
        says water imex3
        continue ;;
    pcisph) # wants solids that keep a pressure, and says so
        expect 2 check "$scenes/small-2d.scene" --method "$name"
        says 'walls = "own-density"'
        expect 0 check "$scenes/small-2d.scene" --method "$name" walls=own-density
        continue ;;
    esac
    brief || expect 0 check "$scenes/small-2d.scene" --method "$name" # all the same to a sanitizer
done
# its flow without gravity; sqrt(2 g 0.2 m); its lid; gravity along what repeats, no fall
for pair in taylor-green:0.998 dam-break:1.98 driven-cavity:1 poiseuille:0; do
    expect 0 check "${top_srcdir:-.}/data/scenes/${pair%:*}.scene"
    says "speed to expect ${pair#*:} m/s"
done
grep -q noticeably said && complain "$what: water at rest is not compressible"
expect 0 check "${top_srcdir:-.}/data/scenes/dam-break.scene" 'gravity=[0,9.81]' # up to the lid
says 'speed to expect 2.8 m/s'
expect 0 check "${top_srcdir:-.}/data/scenes/dam-break.scene" eos.c0=10
says 'Mach 0.2: the fluid will be noticeably compressible'
grep -A40 '^passes' said | sed -n 's/^  \([a-z.][a-z. -]*[a-z]\)   *\(pairs\|points\|bodies\) .*/\1/p' >passes
tr '\n' , <passes >line
order='motion of solids,list of pairs,pressure of solids,records,.*laws between particles'
grep -q "^$order,.*rates of the fluid,.*book," line ||
    complain "$what: passes in another order: $(cat line)"
grep '^  laws between particles ' said |
    grep -q 'force, power, rate of density; of neighbours: position, velocity, density, pressure$' ||
    complain "$what: what laws give, and read of neighbours"
for name in scene kernel domain reference eos output fluid wall probe panel effects.continuity; do
    expect 0 explain $name
done
expect 0 explain artificial-viscosity
says alpha 0.02 gradW Monaghan

# --- mistakes -------------------------------------------------------------------------------
expect 2
says Usage
expect 2 rnu "$scenes/small-2d.scene"
says rnu run --help
expect 2 continue small-2d
says continue "no such command"
expect 2 list efects
says efects effects
for key in tol eos.gamma beam.plate.E effects.artificial-viscosity.alpha fluid.water.dye kernel.support; do
    expect 0 explain $key
    says "  ${key##*.} " "      "
done
expect 0 explain gamma
says "eos, tait" "mps"
expect 0 explain effects.density-diffusion.delta
[ "$(wc -l <said)" = 3 ] || complain "one key is more than one row: $(cat said)"
for value in compound hull elastica max; do # values of keys, some of them in 3D alone
    expect 0 explain $value
    says "one of:" " $value"
done
for table in contact fluid wall probe panel beam body; do # NAME stands for that of any object
    for any in NAME any-thing; do
        expect 0 explain $table.$any
        says "$table.NAME" "      "
        [ "$(wc -l <said)" -ge 8 ] || complain "explain $table.$any says too little"
    done
done
expect 0 explain contact
says "contact.NAME" friction Crespo
expect 0 explain contact.NAME
says friction restitution
expect 0 explain effects.NAME
says continuity
expect 2 explain fluid.dyee
says 'did you mean fluid.dye'
expect 2 explain eos.NAME
expect 2 explain eos.gammma
expect 2 explain effects.pressure.gamma
expect 2 explain .
expect 2 explain continuty
says continuty continuity
expect 2 run
says SCENE
expect 2 run "$scenes/small-2d.scene" --tool 3
says tool --help
expect 2 run "$scenes/small-2d.scene" --threads none
says none
expect 2 run "$scenes/small-2d.scene" another.scene
says another.scene KEY=VALUE
expect 2 run "$scenes/small-2d.scene" --until soon
says until soon
expect 2 check "$scenes/small-2d.scene" -u 2 until=3
says 'until is set twice, by an option to 2 and by a word to 3'
expect 2 run "$scenes/small-2d.scene" --method leapfrog9
says leapfrog9
expect 2 run "$scenes/small-2d.scene" --method leapfrog@fast
[ -z "$(find . -type d ! -name .)" ] || complain "a mistake leaves a directory: $(ls)"

# --- where results go -----------------------------------------------------------------------
expect 0 run "$scenes/small-2d.scene" -q until=0.002
[ -f small-2d/run.json ] || complain "the default directory is not the scene's name"
grep -q '^method = "[a-z0-9]*";  # computed' small-2d/scene.used || complain "scene.used does not say which method"
expect 0 run "$scenes/small-2d.scene" -q until=0.004 -o small-2d
grep -q '"t_end": 0.004' small-2d/run.json || complain "a second run does not replace the first"
expect 0 run "$scenes/small-3d.scene" -q until=0.002 -o three
grep -q '"dimension": 3' three/run.json || complain "a scene in 3D runs in two dimensions"
expect 0 run "$scenes/small-2d.scene" -q until=0.002 -o deep/er/still
[ -f deep/er/still/run.json ] || complain "directories on the way are not made"

# --- a scene through a pipe, which can be read once only -----------------------------------
# piped STATUS SCENE WORD ...: the scene comes through standard input.
piped()
{
    wanted=$1
    scene=$2
    shift 2
    tried=$((tried + 1))
    cat "$scene" | timeout 300 "$STIFFWATER" "$@" >said 2>&1
    found=$?
    what="$scene through a pipe: $*"
    [ $found = "$wanted" ] || complain "$what: exit status $found instead of $wanted"
}

hash()
{
    sed -n 's/.*"state_hash": "\(.*\)".*/\1/p' "$1/run.json"
}

expect 0 run "$scenes/small-2d.scene" -q until=0.002 -o filed
piped 0 "$scenes/small-2d.scene" run /dev/stdin -q until=0.002 -o piped
[ -n "$(hash filed)" ] && [ "$(hash filed)" = "$(hash piped)" ] || complain "$what: another result"
piped 0 "$scenes/small-3d.scene" check /dev/fd/0
says 'Small tank in 3D'
tried=$((tried + 1))
cat "$scenes/small-2d.scene" | "$STIFFWATER" check /dev/fd/7 7<&0 >said 2>&1 </dev/null ||
    complain 'a scene through descriptor 7 is refused'
piped 2 /dev/null check /dev/stdin
says '/dev/stdin: this scene is empty'
sed 's/^until.*/until = ;/' "$scenes/small-2d.scene" >bad.scene
piped 2 bad.scene check /dev/stdin
says '/dev/stdin:6: until has no value'
tried=$((tried + 1))
yes '# a remark' | timeout 300 "$STIFFWATER" check /dev/stdin >said 2>&1
[ $? = 2 ] || complain 'a pipe without an end is not refused'
what='a pipe without an end'
says '8 MB'
mkfifo fifo
cat "$scenes/small-2d.scene" >fifo &
expect 2 check fifo
says 'fifo: this scene is a pipe with a name' '/dev/stdin <fifo'
"$STIFFWATER" check /dev/stdin <fifo >said 2>&1 || complain 'a pipe with a name as standard input'
expect 2 check /dev/fd/99
says '/dev/fd/99' 'cannot read this scene'

# --- stopped on request ---------------------------------------------------------------------
# whole DIR: every row of every table has all its fields, and ends its line.
whole()
{
    for table in "$1"/*.csv; do
        awk -F, '/^#/ { next } { gsub(/"[^"]*"/, "text") } !n { n = NF }
                 NF != n { exit 1 } END { exit NR < 3 }' "$table" ||
            complain "$table is cut off"
        [ -z "$(tail -c 1 "$table")" ] || complain "$table ends in the middle of a line"
    done
}

for signal in INT TERM; do
    tried=$((tried + 1))
    # sh starts background jobs with SIGINT ignored; env sets it back where it can
    env --default-signal=INT "$STIFFWATER" run "$scenes/small-2d.scene" -q until=1e3 \
        output.interval=1e-3 output.fields=10 -o stopped >said 2>&1 &
    pid=$!
    waited=0
    until [ "$(cat stopped/steps.csv 2>&1 | wc -l)" -gt 40 ] || [ $waited = 100 ]; do
        sleep 0.1
        waited=$((waited + 1))
    done
    kill -s $signal $pid
    wait $pid
    found=$?
    [ $found = 3 ] || complain "SIG$signal: exit status $found instead of 3"
    grep -q '"status": "stopped"' stopped/run.json || complain "SIG$signal: run.json is not stopped"
    grep -q "signal" said || complain "SIG$signal: nothing is said"
    whole stopped
    end=$(sed -n 's/.*"t_end": \([^,]*\),.*/\1/p' stopped/run.json)
    last=$(tail -n 1 stopped/book.csv | cut -d, -f1)
    awk -v a="$end" -v b="$last" 'BEGIN { d = a - b; exit !(d * d < 1e-12 && a > 0) }' ||
        complain "SIG$signal: the run ended at $end s, its book at $last s"
    rm -rf stopped
done

# A signal before the first file: there is nothing to save.  (What the user tells glibc stays.)
GLIBC_TUNABLES=glibc.malloc.mxfast=64 "$STIFFWATER" run "$top_srcdir/data/scenes/dam-break-3d.scene" -q spacing=0.00925 -o early >said 2>&1 &
pid=$!
waited=0
# on a busy machine it takes its time to be more than a copy of this shell, which catches signals, too, and
# to load; bit 14 of what it catches is SIGTERM
until grep -q '^stiffwater-3d' /proc/$pid/comm && grep -q '^SigCgt:.*[4-7c-f]...$' /proc/$pid/status ||
    [ $waited = 200 ]; do
    sleep 0.05
    waited=$((waited + 1))
done
tr '\0' : </proc/$pid/environ | # glibc cuts its variable into its words
    grep -q 'GLIBC_TUNABLES=glibc.malloc.mxfast=64:glibc.malloc.hugetlb=1:' ||
    complain "large pages are not asked for, or what the user tells glibc is gone"
kill -s TERM $pid
wait $pid
found=$?
[ $found = 3 ] || complain "SIGTERM before the start: exit status $found instead of 3"
grep -q 'before the first file' said || complain "SIGTERM before the start: $(cat said)"
[ ! -e early ] || complain "SIGTERM before the start: it leaves files"

# --- a method that cannot serve ---------------------------------------------------------------
sed 's/^until.*/until = 0.01;\nmethod = "mri";/' "$top_srcdir/data/scenes/dam-break.scene" >alone.scene
line=$(sed -n '/^method/=' alone.scene)
expect 2 check alone.scene
says "alone.scene:$line: method mri cannot serve this scene" 'no beam' 'methods that do: cks43, imex2'
expect 2 check "$top_srcdir/data/scenes/dam-break.scene" method=dv effects.particle-shifting.strength=0.5
says 'command line: method dv' effects.particle-shifting 'methods that do: '

# --- lengths that no spacing fits ---------------------------------------------------------------
expect 2 check "$top_srcdir/data/scenes/dam-break-3d.scene" 'fluid.back.to=[1.2345,0.7131,0.551]' spacing=0.04
says 'no spacing from 0.02 m to 0.08 m' 'make it 1.2 m or 1.24 m long'

# --- where nothing can be written -----------------------------------------------------------
: >file
expect 4 run "$scenes/small-2d.scene" -q until=0.002 -o file/below
says file
expect 4 run "$scenes/small-2d.scene" -q until=0.002 -o /proc/results
says /proc
if [ "$(id -u)" != 0 ]; then
    mkdir locked && chmod a-w locked
    expect 4 run "$scenes/small-2d.scene" -q until=0.002 -o locked/results
    says locked
fi

# --- a title that would command the terminal ----------------------------------------------------
expect 0 check "${top_srcdir:-.}/tests/scenes/small-2d.scene" 'title="a\x1b[31mred"'
says 'a?[31mred'

# --- figures of a directory that a stranger has had in hand -------------------------------------
if command -v gnuplot >/dev/null; then
    "$STIFFWATER" run "${top_srcdir:-.}/tests/scenes/small-2d.scene" -q until=0.002 \
        "title=\"'quoted' tank \\\"\`touch told\`@x\\\"\"" -o strange >said 2>&1 ||
        complain "a title in quotes: $(cat said)"
    expect 0 plot strange
    says strange/figures/energies.png
    mkdir -p "strange/figures"
    printf '#!/bin/sh\ntouch "%s/gnuplot-told"\n' "$PWD" >gnuplot
    chmod +x gnuplot
    cp gnuplot strange/figures/gnuplot
    for one in strange/figures/*.gp; do
        case $one in */constants.gp) ;; *) echo "system('touch $PWD/told')" >>"$one" ;; esac
    done
    path=$PATH
    PATH=.::$PATH
    expect 0 plot strange
    PATH=$path
    [ -s strange/figures/style.gp.mine ] || complain "a changed script is not kept"
    echo "system('touch $PWD/told')" >>strange/figures/constants.gp
    expect 4 plot strange
    says "constants.gp:" "no constant"
    [ ! -e told ] && [ ! -e gnuplot-told ] || complain "plot carries out what it finds in a directory"
    [ -z "$(find strange -name '.figures-*')" ] || complain "plot leaves a directory behind"
fi

finish
