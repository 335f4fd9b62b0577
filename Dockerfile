# SPDX-License-Identifier: Apache-2.0
#
# Debian with the packages that Halfspace is built from; their list is in ./run. The tree is
# mounted:
#   docker build --tag halfspace .
#   docker run --rm --volume "$PWD:/halfspace" halfspace demo
ARG DEBIAN=bookworm
FROM debian:${DEBIAN}
WORKDIR /halfspace
COPY run ./
RUN ./run install && rm -rf /var/lib/apt/lists/*
ENTRYPOINT ["./run"]
