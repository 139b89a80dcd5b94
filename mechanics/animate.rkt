#lang racket/base
;; Motion as pictures: animations, the drawings of mechanisms that they are made with, and
;; the parts of drawings.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require "show/animation/animation.rkt" "show/animation/animation-frame.rkt"
         "show/animation/animation-show.rkt" "show/animation/drawing.rkt"
         "show/animation/phase-plane.rkt" "show/animation/shapes.rkt"
         "show/mechanism/draw-Atwood-machine.rkt" "show/mechanism/draw-bead.rkt"
         "show/mechanism/draw-orbit.rkt" "show/mechanism/draw-pendulum-chain.rkt"
         "show/mechanism/draw-pendulum.rkt" "show/mechanism/draw-plane-body.rkt"
         "show/mechanism/draw-spherical-pendulum.rkt" "show/mechanism/draw-spring.rkt"
         "show/mechanism/draw-top.rkt" "show/mechanism/draw-wheel.rkt"
         "show/mechanism/mechanism-parts.rkt")

(provide
 ;; animations
 animate animation? animation-frame animation-save animation-show
 phase-plane phase-plane?
 ;; mechanisms
 draw-pendulum draw-driven-pendulum draw-pendulum-chain draw-cart-pendulum
 draw-spherical-pendulum draw-Foucault-pendulum
 draw-oscillator draw-spring-pendulum
 draw-bead-on-ring draw-bead-on-track draw-Atwood-machine draw-ladder
 draw-wheel draw-coin draw-sleigh draw-top draw-brick
 draw-orbit draw-bodies
 ;; drawings of one's own, still pictures
 make-drawing drawing? sketch diagram
 polyline disc label
 rod bob spring wall block vector-arrow angle-mark length-mark)
