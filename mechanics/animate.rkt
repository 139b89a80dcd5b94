#lang racket/base
;; Motion as pictures: animations, the drawings of mechanisms that they are made with, and
;; what drawings are made of.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require "animation/animation.rkt" "animation/animation-frame.rkt"
         "animation/animation-show.rkt" "animation/drawing.rkt"
         "animation/phase-plane.rkt" "animation/shapes.rkt"
         "animation/mechanism/draw-Atwood-machine.rkt" "animation/mechanism/draw-bead.rkt"
         "animation/mechanism/draw-orbit.rkt" "animation/mechanism/draw-pendulum-chain.rkt"
         "animation/mechanism/draw-pendulum.rkt" "animation/mechanism/draw-plane-body.rkt"
         "animation/mechanism/draw-spherical-pendulum.rkt" "animation/mechanism/draw-spring.rkt"
         "animation/mechanism/draw-top.rkt" "animation/mechanism/draw-wheel.rkt"
         "animation/mechanism/mechanism-parts.rkt")

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
