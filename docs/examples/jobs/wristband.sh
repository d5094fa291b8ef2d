# A wristband: a ring of 10 points around a wrist of 160 mm.
set -e
acoustic-fem new band --around 160 --points 10
acoustic-fem check band.toml
