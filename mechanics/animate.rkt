#lang racket/base
;; Motion as pictures: animations, the drawings of mechanisms that they are made with, and
;; what drawings are made of.

(require "animation/animation.rkt" "animation/animation-frame.rkt" "animation/drawing.rkt"
         "animation/draw-pendulum.rkt" "animation/parts.rkt" "animation/phase-plane.rkt"
         "animation/shape.rkt")

(provide
 ;; animations
 animate animation? animation-frame animation-save
 phase-plane phase-plane?
 ;; mechanisms
 draw-pendulum draw-driven-pendulum
 ;; drawings of one's own, still pictures
 make-drawing drawing? sketch diagram
 polyline disc label
 rod bob spring wall block vector-arrow angle-mark length-mark)
