# filtered.gp -- what figures of forces and gauges share: means over a window beside raw rows, axes
# that single peaks do not set, and what sound there is.  Needs `table', and style.gp before.
#
# A mean stands in the middle of its window, which is a hundredth of the run and at least four
# rows.  Of a force it is the difference of its impulse, which the run integrates at every step,
# of other columns the area below the rows.
eval read_names
stats table using 1 skip 2 nooutput name 't'
interval = t_records > 1 ? (t_max - t_min) / (t_records - 1) : until
K = int(until / 100 / interval + 0.5)
K = K < 4 ? 4 : K
array ring_t[K]
array ring_v[K]

# mean(i, t, v): row i, from 0, has the integral v at t; leaves the middle of its window in `middle'.
slot(i) = 1 + int(i) % K
begin(t, v) = (first_t = t, first_v = v)
old(i) = (old_t = i < K ? first_t : ring_t[slot(i)], old_v = i < K ? first_v : ring_v[slot(i)])
store(i, t, v) = (ring_t[slot(i)] = t, ring_v[slot(i)] = v)
mean(i, t, v) = (i == 0 ? begin(t, v) : 0, old(i), store(i, t, v), middle = (t + old_t) / 2, \
    t > old_t ? (v - old_v) / (t - old_t) : NaN)
# area(i, t, v): the integral of readings by the trapezoidal rule
area(i, t, v) = (sum = i == 0 ? 0 : sum + (t - last_t) * (v + last_v) / 2, last_t = t, \
    last_v = v, sum)

# `eval start_limits', then widen() by means, then `eval limits': the axis goes by low and high of means, with room for most of what is raw.
# What lies below `rounding', a part of the weight of the water, is nothing to draw.
rounding = a > 0 && n2 > 0 && g > 0 ? 1e-9 * rho0 * g * n2 * a**2 * (dim == 2 ? 1 : a) : 0
limits = "span = high - low; span = span > 0 ? span : (abs(high) > 0 ? abs(high) : 1); \
    low = low - 0.35 * span; high = high + 0.35 * span"
start_limits = "set yrange [*:*]; low = 1e300; high = -1e300" # `stats' looks within the range
widen(v) = (low = v < low ? v : low, high = v > high ? v : high, v)

# `eval beyond' with a column c, its name and a factor: says which peak the axis leaves out.
beyond = "stats table using (factor * column(c)) skip 2 nooutput name 'raw'; \
    if (raw_max > high) { cut = cut.sprintf('%s%s to %.3g at %.3g s', strlen(cut) ? ';  ' : '', called, raw_max, \
        t_min + interval * raw_index_max) }; \
    if (raw_min < low) { cut = cut.sprintf('%s%s to %.3g at %.3g s', strlen(cut) ? ';  ' : '', called, raw_min, \
        t_min + interval * raw_index_min) }"

# The slowest sounds of a column of water, from what holds it to what is free.
say_means = sprintf('Thin: rows as they are. Thick: means over %.3g ms.', 1e3 * K * interval)
if (!exists('rings')) { rings = 1 }   # of an older version
say_sound = rings && a > 0 && n2 > 0 && c0 > 0 ? sprintf('Water that is let go from a hydrostatic start rings: \
periods about 4a/c0 = %.3g ms (its width a) and 4H/c0 = %.3g ms (its height H).', \
    4e3 * a / c0, 4e3 * n2 * a / c0) : ''
faint(k) = '#80'.substr(pick(k), 2, 7)
foot = "set label 11 say_means at screen 0.02, screen 42.0 / tall font ',12' tc rgb '#404040'; \
    set label 12 say_sound at screen 0.02, screen 20.0 / tall font ',12' tc rgb '#404040' noenhanced"
# `eval place' puts panel number `panel' of `panels'.
place = "set tmargin at screen 1 - (60.0 + (panel - 1) * each) / tall; \
    set bmargin at screen 1 - (60.0 + panel * each - 25) / tall; \
    set format x panel == panels ? '%g' : ''; set xlabel panel == panels ? 'time [s]' : ''"
