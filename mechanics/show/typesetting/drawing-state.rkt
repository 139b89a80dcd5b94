#lang racket/base
;; The state of a drawing context: pen, brush, letters.

(require racket/class)

(provide call-restoring-state)

;; Calls draw!, which may set the state of dc, and restores the state.
(define (call-restoring-state dc draw!)
  (define-values (pen brush font foreground mode smoothing)
    (values (send dc get-pen) (send dc get-brush) (send dc get-font)
            (send dc get-text-foreground) (send dc get-text-mode) (send dc get-smoothing)))
  (draw!)
  (send* dc
    (set-pen pen) (set-brush brush) (set-font font)
    (set-text-foreground foreground) (set-text-mode mode) (set-smoothing smoothing)))
