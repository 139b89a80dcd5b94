#lang racket/base
;; Motion as pictures: animations, the drawings of mechanisms that they are made with, and
;; what drawings are made of.

(require "animation/animation.rkt" "animation/animation-frame.rkt"
         "animation/animation-show.rkt" "animation/drawing.rkt"
         "animation/draw-Atwood-machine.rkt" "animation/draw-bead.rkt" "animation/draw-orbit.rkt"
         "animation/draw-pendulum-chain.rkt" "animation/draw-pendulum.rkt"
         "animation/draw-plane-body.rkt" "animation/draw-spherical-pendulum.rkt"
         "animation/draw-spring.rkt" "animation/draw-top.rkt" "animation/draw-wheel.rkt"
         "animation/mechanism-parts.rkt" "animation/phase-plane.rkt" "animation/shapes.rkt")

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
