// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A canvas or a box of the pages' size.
export function box(kind = "canvas") {
  const one = document.createElement(kind);
  one.style.cssText = "display: block; width: 460px; height: 340px; position: relative";
  if (kind === "canvas") { one.width = 460; one.height = 340; }
  document.body.appendChild(one);
  return one;
}

export function turn(draw) {
  let frame = 0;
  const next = () => { draw(frame++); requestAnimationFrame(next); };
  next();
}
