% SPDX-FileCopyrightText: 2026 The glark authors
% SPDX-License-Identifier: MIT
% A lit surface and a coarse ball in an Octave figure that turns, for scripts/strangers.
graphics_toolkit ("qt");
figure ("position", [0 0 400 300]);
subplot (1, 2, 1);
[x, y] = meshgrid (linspace (-2, 2, 14));
surf (x, y, x .* exp (-x.^2 - y.^2));
shading interp;
light ();
lighting gouraud;
subplot (1, 2, 2);
sphere (12);
light ();
lighting gouraud;
axis equal;
for angle = 0:4:120
  for axes = get (gcf, "children")'
    view (axes, angle, 25);
  endfor
  drawnow ();
endfor
