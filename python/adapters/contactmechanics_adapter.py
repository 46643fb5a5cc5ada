#!/usr/bin/env python3
"""Solve an Asperity problem by ContactMechanics
(https://github.com/ContactEngineering/ContactMechanics).

    contactmechanics_adapter.py PROBLEM_DIR SUBMISSION_DIR [--accuracy best]

Uses the periodic half-space with zero stiffness of the mean displacement, and the
constrained conjugate gradients at a given force. The tolerance is the largest
penetration over h_rms; "default" leaves it to ContactMechanics.
"""
import submission


def prepare(problem):
    import ContactMechanics
    from SurfaceTopography import Topography

    # The first index of a topography is x.
    sizes = (problem.length_x, problem.length_y)
    area = problem.length_x * problem.length_y
    heights = problem.heights.T
    substrate = ContactMechanics.PeriodicFFTElasticHalfSpace(
        heights.shape, problem.contact_modulus, sizes, stiffness_q0=0.0)
    surface = Topography(heights, physical_sizes=sizes, periodic=True)
    system = ContactMechanics.make_system(substrate=substrate, surface=surface)

    def solve(nominal_pressure, tolerance):
        penetration = None if tolerance is None else tolerance * heights.std()
        result = system.minimize_proxy(external_force=nominal_pressure * area, pentol=penetration)
        pressure = result.jac.T / substrate.area_per_pt
        claims = {"mean_gap": float((result.x - heights).mean() - result.offset),
                  "contact_area_fraction": float((pressure > 0).mean()),
                  "elastic_energy": float(result.fun / area), "iterations": result.nit}
        return pressure, result.success, claims

    return ContactMechanics.__version__, solve


if __name__ == "__main__":
    submission.run(prepare, "ContactMechanics", "FFT boundary elements, conjugate gradients",
                   tolerances={"default": None, "best": 1e-10})
