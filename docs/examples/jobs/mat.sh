# A mat: 100 points on 1 m x 1 m do not work for a finger, so the second command asks for what the first one suggests.
acoustic-fem new mat --size 1000x1000 --points 100 --microphones 4
set -e
acoustic-fem new mat --size 1000x1000 --points 100 --microphones 11 --target "hand 1 N"
acoustic-fem check mat.toml
