// Moves through the frames of this page's interactions.  Beside the controls of each stands
//   elements  markup, each of which stands in one frame or more
//   frames    lists of numbers of elements, those of the last control next to each other
//   labels    for each control the texts of its values
"use strict";
for (const box of document.querySelectorAll(".interaction")) {
  const data = JSON.parse(box.querySelector("script").textContent);
  const live = box.querySelector(".live");
  const controls = [...box.querySelectorAll(".control")];
  const position = c => {
    const input = c.querySelector("input, select");
    return input === null ? 0 : input.type === "checkbox" ? Number(input.checked)
                                                          : Number(input.value);
  };
  const show = () => {
    let frame = 0;
    controls.forEach((c, k) => {
      frame = frame * data.labels[k].length + position(c);
      const output = c.querySelector("output");
      if (output) output.textContent = data.labels[k][position(c)];
    });
    live.innerHTML = data.frames[frame].map(e => data.elements[e]).join("");
  };
  for (const input of box.querySelectorAll("input, select")) input.addEventListener("input", show);
  box.querySelector(".controls").hidden = false;
  box.classList.add("moving");
  show();
}
