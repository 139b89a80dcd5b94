#lang racket/base
;; Names of `mechanics/scmutils`, with what `mechanics` has in their place: the table of which that
;; library is made, and a sentence for whoever types such a name without it.

(provide replacements scmutils-names scmutils-sentence)

;; (replacement name ...) ...
;; A symbol is what the names are other names for.  A text is advice: these names are procedures of
;; their own.
(define replacements
  '((print-expression pe)
    (show-expression se)
    (D derivative)
    (constant-function constant)
    (literal-up literal-up-tuple)
    (literal-down literal-down-tuple)
    (factor factor-polynomial-expression)
    (golden-ratio :phi)
    ("ref" s:ref)
    ("dimension" s:dimension)
    ("structure-orientation" s:same)
    ("(structure-orientation (flip s))" s:opposite)
    (compatible-zero dual-zero)
    (matrix-by-columns matrix-by-cols)
    (m:generate matrix:generate)
    (identity-matrix m:make-identity)
    (null-space lu-null-space)
    (up->column-matrix vector->column-matrix)
    (down->row-matrix vector->row-matrix)
    ("(up->column-matrix (up x ...))" column-matrix)
    ("(down->row-matrix (down x ...))" row-matrix)
    ("(structure->vector (column-matrix->up m))" column-matrix->vector)
    ("(structure->vector (row-matrix->down m))" row-matrix->vector)
    ("(m:generate rows columns f)" literal-matrix)
    (Gamma path->state-path)
    (->local ->state ->L-state)
    (up coordinate-tuple velocity-tuple acceleration-tuple)
    (down momentum-tuple)
    (time state->t)
    (coordinate state->q Q)
    (velocity state->qdot Qdot)
    (acceleration state->qddot Qdotdot)
    (momentum state->p P)
    ("(dimension (coordinate local))" state->n-dof)
    ("(Lagrange-equations L #:order 2)" generalized-LE)
    (Euler-Lagrange-operator LE Lagrange-equations-operator)
    (Lagrangian->state-derivative local-state-derivative)
    (Lagrange-equations-first-order Lagrange-equations-1)
    (qv->state-path qv->local-path)
    (Hamiltonian->state-derivative phase-space-derivative)
    (p->r polar->rectangular)
    (r->p rectangular->polar)
    (s->r spherical->rectangular)
    (r->s rectangular->spherical)
    (Rx rotate-x)
    (Ry rotate-y)
    (Rz rotate-z)
    ("Rx-matrix" rotate-x-matrix)
    ("Ry-matrix" rotate-y-matrix)
    ("Rz-matrix" rotate-z-matrix)
    (angle-axis->rotation-matrix angle&axis->rotation-matrix)
    (Phi* transpose-function)
    (Hpendulum pendulum-Hamiltonian)
    ("(definite-integral f low high #:tolerance tolerance)" definite-integral-with-tolerance)
    ("(minimize f low high)" brent-min golden-section-min)
    ("(find-root f start)" newton-search)
    ("(find-root f low high)" zbrent)
    ("D-numeric" richardson-derivative)
    ("(Bessel-J n x)" bessj)
    ("(Bessel-J 0 x)" bessj0)
    ("(Bessel-J 1 x)" bessj1)))

(define replacement-of
  (for*/hasheq ([entry (in-list replacements)] [name (in-list (cdr entry))])
    (values name (car entry))))

(define scmutils-names (hash-keys replacement-of))

;; -> text or #f
(define (scmutils-sentence name)
  (define replacement (hash-ref replacement-of name #f))
  (and replacement
       (format "~a is scmutils' name of ~a; (require mechanics/scmutils) has it"
               name replacement)))
