"""Maps explored: a picture that is clicked, and buttons beneath it.

The picture is an output of its own, a page's element, so that a saved notebook shows it as it was
last.  Its script writes where it was clicked into a field of ipywidgets, which is not seen; so the
place comes to the kernel as the value of a slider does.
"""

import base64
import html
import json
import threading
import uuid

import ipywidgets

from .interaction import GONE

SVG, HTML, PLAIN = "image/svg+xml", "text/html", "text/plain"
BUTTONS = ["Undo", "More", "Whole", "Clear"]
HELP = "click: orbit; drag: zoom"

# The place where the button went down is kept by the window: the picture may be replaced meanwhile.
DOWN = """event.preventDefault(); const r = this.getBoundingClientRect();
window.mechanicsFrom = [(event.clientX - r.left) / r.width, (event.clientY - r.top) / r.height]"""
MOVE = """const from = window.mechanicsFrom; if (from && event.buttons) {
const r = this.getBoundingClientRect(), band = this.lastElementChild.style,
x = (event.clientX - r.left) / r.width, y = (event.clientY - r.top) / r.height;
band.display = 'block';
band.left = 100 * Math.min(x, from[0]) + '%'; band.width = 100 * Math.abs(x - from[0]) + '%';
band.top = 100 * Math.min(y, from[1]) + '%'; band.height = 100 * Math.abs(y - from[1]) + '%' }"""
UP = """const from = window.mechanicsFrom; window.mechanicsFrom = null;
this.lastElementChild.style.display = 'none';
const field = document.querySelector('.NAME input'), r = this.getBoundingClientRect();
if (from && field) { field.value = JSON.stringify([...from,
(event.clientX - r.left) / r.width, (event.clientY - r.top) / r.height, Date.now()]);
for (const kind of ['input', 'change']) field.dispatchEvent(new Event(kind, {bubbles: true})) }"""
BAND = "display:none;position:absolute;border:1px dashed gray;pointer-events:none"


class Exploration:
    """update(data) shows the picture where it was shown before."""

    patient = True

    def __init__(self, message, worker, child, update):
        self.number, self.worker, self.child, self.update = message["number"], worker, child, update
        self.name = f"mechanics-{uuid.uuid4().hex}"
        self.turn, self.actions = threading.Lock(), []
        self.field = ipywidgets.Text(layout={"display": "none"})
        self.field.add_class(self.name)
        self.field.observe(self.clicked, "value")
        buttons = [ipywidgets.Button(description=name, layout={"width": "auto"}) for name in BUTTONS]
        for button in buttons:
            button.on_click(lambda b: self.act(b.description.lower()))
        self.words = ipywidgets.Label()
        self.widget = ipywidgets.HBox([*buttons, self.words, self.field])
        self.say(message)
        if message["more"]:
            worker.want(self, None)

    def clicked(self, change):
        try:
            *place, _ = map(float, json.loads(change["new"]))
        except ValueError:
            return
        if len(place) == 4:
            self.act("point", *place)

    def act(self, *action):
        with self.turn:
            self.actions.append(action)
        self.worker.want(self, None)

    def question(self, _):
        with self.turn:
            actions, self.actions = self.actions, []
        return {"do": "explore", "number": self.number, "actions": actions}

    def answered(self, answer):
        if "data" in answer:
            self.say(answer)
            self.update(answer["data"])
            if answer["more"]:
                self.worker.want(self, None)

    def gone(self):
        self.words.value = GONE

    def say(self, answer):
        text = answer["text"]
        self.words.value = HELP if text.startswith("0 orbits") else text

    def page(self, data):
        """The picture as an element that tells where it is clicked."""
        if SVG not in data:
            return data
        source = "data:image/svg+xml;base64," + base64.b64encode(data[SVG].encode()).decode()
        handlers = " ".join(f'{kind}="{html.escape(script.replace("NAME", self.name))}"'
                            for kind, script in [("onpointerdown", DOWN), ("onpointermove", MOVE),
                                                 ("onpointerup", UP)])
        element = (f'<div style="position:relative;display:inline-block;cursor:crosshair;'
                   f'touch-action:none" {handlers}>'
                   f'<img alt="{html.escape(data[PLAIN])}" draggable="false" src="{source}">'
                   f'<div style="{BAND}"></div></div>')
        return {**{kind: data[kind] for kind in data if kind != SVG}, HTML: element}

    def bundle(self):
        view = {"version_major": 2, "version_minor": 0, "model_id": self.widget.model_id}
        return {PLAIN: "", "application/vnd.jupyter.widget-view+json": view}
