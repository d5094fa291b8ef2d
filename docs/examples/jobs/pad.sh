# A gripper's pad: 16 points on 30 x 30 mm, microphones included, from a desktop resin printer.
set -e
acoustic-fem new pad --size 30x30 --points 16 --microphones 2
acoustic-fem check pad.toml
