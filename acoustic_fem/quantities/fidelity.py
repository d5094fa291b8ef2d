"""The fidelities: what the cells of an array may be computed with."""

from typing import Literal, get_args

#: 3-D models: the one to trust, and the scalar one for straight ducts and cross-checks.
Physics = Literal["navier-stokes", "helmholtz"]
PHYSICS: tuple[Physics, ...] = get_args(Physics)

#: Fidelities whose cells are closed forms: alone, or with what 3-D adds to them from a table.
ClosedForm = Literal["lumped", "atlas"]
CLOSED_FORMS: tuple[ClosedForm, ...] = get_args(ClosedForm)

#: Ways to compute the cells of an array, from the fastest to the one to trust.
Fidelity = Literal["lumped", "atlas", "helmholtz", "navier-stokes"]
#: Names of all fidelities, from closed forms to the one to trust.
FIDELITIES: tuple[Fidelity, ...] = get_args(Fidelity)

#: Default of one design that is solved, run, calibrated, recorded or evaluated.
ONE_DESIGN: Fidelity = "navier-stokes"
#: Default of many designs and of quick answers (studies, tolerances, ``check``, the studio), where the atlas covers the
#: design; :data:`ONE_DESIGN` where it does not, see :func:`acoustic_fem.atlas.quick_fidelity`.
MANY_DESIGNS: Fidelity = "atlas"
