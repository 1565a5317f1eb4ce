#!/bin/bash -eu
exec bash -eu "$SRC/toolcomp/oss-fuzz/build.sh"
