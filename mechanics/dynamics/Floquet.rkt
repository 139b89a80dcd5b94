#lang racket/base
;; Floquet's multipliers: factors of small displacements of a closed orbit after a period
;; (SICM 4.2).  They are the eigenvalues of the derivatives of the state a period later by the
;; state, which follow from the variational equations (motion/linearized-flow).

(require racket/flonum
         "map/period-check.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/define-plain.rkt"
         "../generic/describe.rkt" "../generic/up-down.rkt"
         "../motion/system/check.rkt" "../motion/evolution.rkt" "../motion/observed-systems.rkt"
         "../motion/linearized-flow.rkt"
         "../numeric/constants.rkt" "../numeric/linear-algebra/general-eigenvalues.rkt"
         "../numeric/whole-turns.rkt"
         "../value/shape.rkt" (only-in "../value/structure.rkt" structure->list))

(provide Floquet-multipliers)

;; The greatest distance between the ends of a closed orbit, relative to 1 + |x|.
(define closure-tolerance 1e-6)

;; -> the eigenvalues, the largest first, of the derivatives of the state one period later by
;; the state; a state (up t q p) is differentiated by all components but the time.
(define-plain (Floquet-multipliers derivative state period #:tolerance [tolerance 1e-12])
  (define who 'Floquet-multipliers)
  (when (and (tuple? period) (not (tuple? state)))
    (complain who "the state comes before the period\n  given second: ~a"
              (describe-with-value state)))
  (check-derivative who derivative state)
  (check-duration who period)
  (check-tolerance who tolerance)
  (check-period who derivative state period)
  (define first (if (timed-state? derivative state) 1 0))
  (define-values (end columns) (displaced who derivative state first period tolerance))
  (check-closed who derivative state end first)
  (define n (length columns))
  (define entries
    (for*/flvector #:length (* n n) ([i (in-range n)] [column (in-list columns)])
      (list-ref column (+ first i))))
  (sort (or (real-matrix-eigenvalues entries n) '()) > #:key magnitude))

;; -> the final state, and the final values of the unit displacements of all scalars from
;; number `first` on.
(define (displaced who derivative state first duration tolerance)
  (note-followed derivative '() state)
  (define start (apply up state (unit-displacements state first)))
  (define (advance)
    ((state-advancer (lambda () (with-displacements derivative))) start duration tolerance))
  (define end (structure->list (call-unwatched (lambda () (call-for-state who advance)))))
  (values (car end) (map scalars (cdr end))))

;; An angle may come back a whole turn on; another coordinate, or a momentum, may not.
(define (check-closed who derivative start end first)
  (define gap
    (for/fold ([most 0.0]) ([a (in-list (scalars start))] [b (in-list (scalars end))]
                            [k (in-naturals)] #:when (>= k first))
      (define x (real->double-flonum (comparand a)))
      (define moved (fl- (real->double-flonum (comparand b)) x))
      (define (beside d) (fl/ (flabs d) (fl+ 1.0 (flabs x))))
      (define-values (all part) (values (beside moved) (beside (whole-turns-less moved))))
      (define angular? (and (fl< part closure-tolerance all) (angle? derivative start k)))
      (flmax most (if angular? part all))))
  (unless (fl< gap closure-tolerance)
    (complain who
              (string-append "the orbit is not closed after that period; its ends are ~a apart"
                             "\n  start: ~a\n  end: ~a")
              gap (value->text start) (value->text end))))

;; Do the rates stay the same when scalar number k of the state grows by a whole turn?
(define (angle? derivative state k)
  (define moved (changed state (lambda (x i) (if (= i k) (g:+ :2pi x) x))))
  (for/and ([a (in-list (scalars (derivative state)))]
            [b (in-list (scalars (derivative moved)))])
    (define rate (real->double-flonum (comparand a)))
    (fl< (flabs (fl- (real->double-flonum (comparand b)) rate))
         (fl* closure-tolerance (fl+ 1.0 (flabs rate))))))
