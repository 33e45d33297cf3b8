# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Generates a loader for OpenGL with glad 2, from Khronos' gl.xml and registries in the same schema.

  generate_loader.py OUT API EXTENSIONS REGISTRY [ADDITION ...]

API and EXTENSIONS are glad's options --api and --extensions. glad reads one registry only, so this script merges the additions
into the first (registry.py). glad also asks the network for gl.xml unless it is told to use its own copy; here it gets the
merged registry instead.
"""
import io
import sys
import xml.etree.ElementTree as ElementTree

import glad.__main__
import glad.files
from registry import merged


def opener_with(registry: bytes) -> type:
    """glad's opener of files that come with it, but for gl.xml."""

    class Opener(glad.files.StaticFileOpener):
        def urlopen(self, url, *arguments, **options):
            if url.endswith("/gl.xml"):
                return io.BytesIO(registry)
            return super().urlopen(url, *arguments, **options)

    return Opener


def main() -> None:
    out, api, extensions, *registries = sys.argv[1:]
    base, *additions = [ElementTree.parse(path).getroot() for path in registries]
    glad.files.StaticFileOpener = opener_with(ElementTree.tostring(merged(base, additions)))
    # --reproducible is what makes glad use this opener; it also leaves out the date. --mx: the functions are members of
    # a struct.
    glad.__main__.main(["--quiet", "--reproducible", "--merge", "--api", api, "--extensions", extensions, "--out-path", out,
                        "c", "--mx"])


if __name__ == "__main__":
    main()
