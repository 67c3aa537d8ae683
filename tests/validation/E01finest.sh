#!/bin/sh
# E01finest.sh -- the dam break on a box with 12.2 mm
#
# E01 with 4/9 of the spacing (360,000 particles of water; tank and column as in E01fine, the column 1.2222 m long), to 0.75 s,
# healed. Run once, kept; again by `make validation CASES=E01finest`.
# Long: half an hour.
. "$(dirname "$0")/lib.sh"
. "$cases/marin.sh"
go healed "$cases/marin.scene" spacing=0.012222222222222223 domain.to=[3.2266666666666667,0.99,0.99] \
    fluid.water.to=[1.2222222222222223,0.99,0.55] until=0.75 eos.tension=false effects.density-healing={} \
    output.fields=0.25
low='P3 and P4 are too low, near the edge over which the water leaves; rises with 1/dx, see E01'
blow='a blow of 0.1 MPa, rho c0 U: a liquid without air, met by all of a flat toe at once; see E01'
impact healed 'healed' "$low" "$blow" '' '' 'one was half a spacing deep in the far wall for a moment (0.65 s); those lost were thrown over the top of the open tank'
done_here
