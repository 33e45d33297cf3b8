# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Mutants that are made by rules, all in one library: ../generated.py runs them."""
