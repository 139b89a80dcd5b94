"""Interactions: controls of ipywidgets, whose values the Racket process is asked for.

Handlers of controls only store where they were moved to.  One worker asks for all interactions:
the newest values come next, and what has begun is finished, unless it takes more than half a
second while newer values wait.  So the last picture is that of the last values, and a drag shows
pictures on its way.  Of a map that is explored (exploration.py) nothing is given up: it is patient.
"""

import concurrent.futures
import threading

import ipywidgets

MOST_LABELS = 1000
PATIENCE = 0.5
GONE = "the definitions that this rests on are gone: run its cell again"


class Worker:
    """ask(interaction, id, question) and stop(id) talk to the process; next_id() names a request.

    ask answers None where the process of the interaction has ended; tell(problem) is for failures.
    """

    def __init__(self, ask, stop, next_id, tell):
        self.ask, self.stop, self.next_id, self.tell = ask, stop, next_id, tell
        self.waiting = {}
        self.something = threading.Condition()
        threading.Thread(target=self.work, daemon=True).start()

    def want(self, interaction, values):
        with self.something:
            self.waiting[interaction] = values
            self.something.notify_all()

    def work(self):
        while True:
            with self.something:
                self.something.wait_for(lambda: self.waiting)
                interaction = next(iter(self.waiting))
                values = self.waiting.pop(interaction)
            try:
                self.show(interaction, values)
            except Exception as problem:
                self.tell(problem)

    def show(self, interaction, values):
        number = self.next_id()
        answer = self.ask(interaction, number, interaction.question(values))
        if answer is None:
            interaction.gone()
            return
        while not concurrent.futures.wait([answer], PATIENCE).done:
            if interaction in self.waiting and not interaction.patient:
                self.stop(number)
        interaction.answered(answer.result())


class Interaction:
    patient = False

    def __init__(self, message, worker, child):
        self.number, self.worker, self.child = message["number"], worker, child
        self.controls = [control_widget(c) for c in message["controls"]]
        self.output = ipywidgets.Output()
        self.show(message["data"])
        for control in self.controls:
            control.observe(self.moved, "value")
        self.widget = ipywidgets.VBox([*self.controls, self.output])

    def moved(self, change):
        self.worker.want(self, [control.value for control in self.controls])

    def question(self, values):
        return {"do": "frame", "number": self.number, "values": values}

    def answered(self, answer):
        if data := answer.get("data"):
            self.show(data)

    def gone(self):
        self.show({"text/plain": GONE})

    def show(self, data):
        self.output.outputs = ({"output_type": "display_data", "data": data, "metadata": {}},)

    def bundle(self, data):
        """As the front end shows it; without widgets, the first value."""
        view = {"version_major": 2, "version_minor": 0, "model_id": self.widget.model_id}
        return {**data, "application/vnd.jupyter.widget-view+json": view}


def control_widget(control):
    kind, start, labels = control["kind"], control["start"], control["labels"]
    settings = {"description": control["name"], "style": {"description_width": "initial"}}
    if kind == "number":
        values = control["values"]
        if len(values) <= MOST_LABELS:
            return ipywidgets.SelectionSlider(options=list(zip(labels, values)), index=start,
                                              continuous_update=True, **settings)
        return ipywidgets.FloatSlider(min=values[0], max=values[-1], step=control["step"],
                                      value=values[start], **settings)
    if kind == "choice":
        return ipywidgets.Dropdown(options=[(label, k) for k, label in enumerate(labels)],
                                   value=start, **settings)
    if kind == "boolean":
        return ipywidgets.Checkbox(value=bool(start), indent=False, **settings)
    return ipywidgets.Text(value=start, **settings)
