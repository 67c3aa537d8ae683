"""The dam break of data/scenes/dam-break.scene in PySPH, to measure both side by side (doc/speed.md).

    apt-get install python3-pysph cython3 python3-dev g++
    OMP_NUM_THREADS=1 python3 bench/pysph-dam-break.py --tf=0.2 -d DIR --disable-output

As near as its options go: column of 0.1 x 0.2 m, tank of 0.4 m, spacing of 2 mm, H = 2.5 spacings, sound at 19.8 m/s, alpha = 0.02,
continuity, Tait; its own integrator (predict, evaluate, correct) and its own bound of steps.  Its walls are three
layers with a density of their own.
"""
import numpy
from pysph.base.kernels import WendlandQuintic
from pysph.base.utils import get_particle_array
from pysph.solver.application import Application
from pysph.sph.integrator import PECIntegrator
from pysph.sph.scheme import WCSPHScheme

SPACING = 2e-3
H = 1.25 * SPACING  # of PySPH: half the support
SOUND = 19.8
LAYERS = 3


def lattice(x0, x1, y0, y1):
    """Centres of the squares of one spacing that fill a rectangle: two flat arrays, m."""
    x = numpy.arange(x0 + SPACING / 2, x1, SPACING)
    y = numpy.arange(y0 + SPACING / 2, y1, SPACING)
    x, y = numpy.meshgrid(x, y)
    return x.ravel(), y.ravel()


class DamBreak(Application):
    def create_particles(self):
        mass = 1000.0 * SPACING ** 2
        x, y = lattice(0, 0.1, 0, 0.2)
        fluid = get_particle_array(name="fluid", x=x, y=y, m=mass, h=H, rho=1000.0)
        rim = LAYERS * SPACING
        x, y = lattice(-rim, 0.4 + rim, -rim, 0.4 + rim)
        outside = (x < 0) | (x > 0.4) | (y < 0) | (y > 0.4)
        wall = get_particle_array(name="wall", x=x[outside], y=y[outside], m=mass, h=H, rho=1000.0)
        self.scheme.setup_properties([fluid, wall])
        return [fluid, wall]

    def create_scheme(self):
        return WCSPHScheme(["fluid"], ["wall"], dim=2, rho0=1000.0, c0=SOUND, h0=H, hdx=1.25, gamma=7.0,
                           gy=-9.81, alpha=0.02, beta=0.0)

    def configure_scheme(self):
        self.scheme.configure_solver(kernel=WendlandQuintic(dim=2), integrator_cls=PECIntegrator, tf=1.0,
                                     dt=1e-5, adaptive_timestep=True, pfreq=100000)

    def post_process(self, info_fname):
        """Says how many steps it took; each evaluates the right-hand side once."""
        print("steps", self.solver.count, "front", max(self.particles[0].x))


if __name__ == "__main__":
    app = DamBreak(fname="dam-break")
    app.run()
    app.post_process(app.info_filename)
