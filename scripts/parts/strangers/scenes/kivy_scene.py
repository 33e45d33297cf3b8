# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Widgets and a lit mesh in a Kivy window, for scripts/strangers."""
import math
import os

os.environ.update(KIVY_NO_ARGS="1", KIVY_NO_CONSOLELOG="1")
from kivy.config import Config
Config.set("graphics", "width", "300")
Config.set("graphics", "height", "300")
from kivy.app import App
from kivy.clock import Clock
from kivy.graphics import Color, Ellipse, Line, Mesh, Rectangle, Rotate, PushMatrix, PopMatrix
from kivy.uix.boxlayout import BoxLayout
from kivy.uix.button import Button
from kivy.uix.slider import Slider
from kivy.uix.widget import Widget


class Scene(Widget):
    def __init__(self, **more):
        super().__init__(**more)
        with self.canvas:
            Color(0.2, 0.4, 0.8)
            Rectangle(pos=(20, 130), size=(120, 120))
            Color(0.9, 0.5, 0.1)
            Ellipse(pos=(60, 150), size=(80, 80), segments=12)
            PushMatrix()
            self.turn = Rotate(angle=0, origin=(220, 190))
            corners = [(220 + 60 * math.cos(a), 190 + 60 * math.sin(a)) for a in (2 * math.pi * i / 7 for i in range(7))]
            Mesh(vertices=[value for x, y in corners for value in (x, y, 0, 0)], indices=list(range(7)), mode="triangle_fan")
            PopMatrix()
            Line(circle=(150, 190, 90), width=3)
        Clock.schedule_interval(self.step, 1 / 30)

    def step(self, seconds):
        self.turn.angle += 3


class Main(App):
    def build(self):
        box = BoxLayout(orientation="vertical")
        box.add_widget(Scene())
        box.add_widget(Button(text="Button", size_hint_y=0.2))
        box.add_widget(Slider(value=40, size_hint_y=0.2))
        return box


Main().run()
