# SPDX-License-Identifier: Apache-2.0
"""Charts of the gallery and of peers: a function each, data in, figure out."""


def methods(data):
    raise NotImplementedError


def stability(data):
    raise NotImplementedError


def peers(data):
    raise NotImplementedError
