#lang racket/base
;; Pictures: frames as in the book, and drawing in them.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require "show/plot/chaos-map.rkt" "show/plot/contour.rkt" "show/plot/draw.rkt"
         "show/explorer/explore-map.rkt"
         "show/plot/following-orbits.rkt" "show/plot/frame.rkt" "show/plot/frame-output.rkt"
         "show/plot/phase-portrait.rkt" "show/plot/plot-branch.rkt" "show/plot/plot-residuals.rkt"
         "show/plot/plot-trajectory.rkt")

(provide
 ;; frames
 frame frame? graphics-clear graphics-close
 ;; drawing
 plot-point plot-line plot-function plot-parametric plot-parametric-fill
 plot-trajectory plot-branch plot-residuals plot-contours plot-phase-portrait
 ;; maps of the plane
 explore-map display-map chaos-map default-collector default-monitor
 ;; the points and curves drawn
 frame-points frame-curves
 graphics-save graphics-show frame->pict)
