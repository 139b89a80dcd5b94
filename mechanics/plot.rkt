#lang racket/base
;; Pictures: frames as in the book, and what is drawn in them.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require "plot/chaos-map.rkt" "plot/contour.rkt" "plot/draw.rkt" "plot/explore-map.rkt"
         "plot/following-orbits.rkt" "plot/frame.rkt" "plot/frame-pict.rkt"
         "plot/phase-portrait.rkt" "plot/plot-trajectory.rkt" "plot/save.rkt" "plot/show.rkt")

(provide
 ;; frames
 frame frame? graphics-clear graphics-close
 ;; drawing
 plot-point plot-line plot-function plot-parametric plot-parametric-fill
 plot-trajectory plot-contours plot-phase-portrait
 ;; maps of the plane
 explore-map display-map chaos-map default-collector default-monitor
 ;; what was drawn
 frame-points frame-curves
 graphics-save graphics-show frame->pict)
