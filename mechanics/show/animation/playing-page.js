// Plays the pictures of this page.  What they consist of stands in the element "motion":
//   elements  markup, each of which stands in one picture or more
//   panels    for each: frames, lists of numbers of elements; trails, lists x y x y ...
//   detail    points of a trail from one picture to the next; back, how many pictures of it show
//   times     the first and the last; rate, pictures in a second
"use strict";
(() => {
  const motion = JSON.parse(document.getElementById("motion").textContent);
  const find = name => document.getElementById(name);
  const play = find("play"), slider = find("slider"), clock = find("clock"),
        speed = find("speed"), trails = find("trails");
  const last = motion.panels[0].frames.length - 1;
  const [first, end] = motion.times;
  let position = 0, playing = false, then = 0;

  function trail(points, frame) {
    const from = motion.back === null ? 0 : Math.max(0, frame - motion.back);
    return points.slice(2 * motion.detail * from, 2 * (motion.detail * frame + 1)).join(" ");
  }

  function show() {
    const frame = Math.min(last, Math.floor(position + 1e-9));
    motion.panels.forEach((panel, i) => {
      find("panel" + i).innerHTML =
        panel.frames[frame].map(k => motion.elements[k]).join("");
      panel.trails.forEach((points, k) => find("trail" + i + "-" + k)
        .setAttribute("points", trails.checked ? trail(points, frame) : ""));
    });
    const time = first + (end - first) * frame / last;
    clock.textContent = "t = " + time.toFixed(2);
    slider.value = frame;
  }

  function step(now) {
    if (!playing) return;
    position += (now - then) / 1000 * motion.rate * Number(speed.value);
    then = now;
    if (position > last + motion.rate / 2) position = 0;   // half a second's rest, then again
    show();
    requestAnimationFrame(step);
  }

  function setPlaying(on) {
    if (on && position >= last) position = 0;
    playing = on;
    play.textContent = on ? "Pause" : "Play";
    if (on) { then = performance.now(); requestAnimationFrame(step); }
  }

  function goTo(frame) {
    setPlaying(false);
    position = Math.max(0, Math.min(last, frame));
    show();
  }

  play.addEventListener("click", () => setPlaying(!playing));
  slider.addEventListener("input", () => goTo(Number(slider.value)));
  trails.addEventListener("change", show);
  document.addEventListener("keydown", event => {
    if (event.target.tagName === "SELECT" || event.target.tagName === "BUTTON") return;
    if (event.key === " ") { event.preventDefault(); setPlaying(!playing); }
    else if (event.target !== slider && event.key === "ArrowRight") goTo(Math.floor(position) + 1);
    else if (event.target !== slider && event.key === "ArrowLeft") goTo(Math.floor(position) - 1);
  });

  find("controls").hidden = false;
  show();
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) setPlaying(true);
})();
