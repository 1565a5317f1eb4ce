#!/bin/bash -eu
# SPDX-License-Identifier: Apache-2.0
exec bash -eu "$SRC/toolcomp/oss-fuzz/build.sh"
