// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A helix of alanine: 24 residues, each with N, CA, C, O and CB, as PDB text.
export function helix(count = 24) {
  const atoms = [["N", 1.55, -0.4, -1.2], ["CA", 2.3, 0, 0], ["C", 1.7, 0.45, 1.0], ["O", 2.0, 0.55, 2.1], ["CB", 3.3, -0.3, 0.2]], lines = [];
  let number = 1;
  for (let i = 0; i < count; i++) {
    for (const [name, radius, turn, rise] of atoms) {
      const angle = (100 * i) * Math.PI / 180 + turn, z = 1.5 * i + rise - 0.75 * count;
      const place = [radius * Math.cos(angle), radius * Math.sin(angle), z].map((v) => v.toFixed(3).padStart(8)).join("");
      lines.push(`ATOM  ${String(number++).padStart(5)}  ${name.padEnd(3)} ALA A${String(i + 1).padStart(4)}    ${place}  1.00 20.00           ${name[0]}  `);
    }
  }
  return `HELIX    1   1 ALA A    1  ALA A${String(count).padStart(5)}  1                                  ${String(count).padStart(2)}\n${lines.join("\n")}\nTER\nEND\n`;
}
