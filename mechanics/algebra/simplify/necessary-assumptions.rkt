#lang racket/base
;; The assumptions that a result needs, of those taken for granted on the way.
;;
;; √((x + a/b)² + y²) is √(…)/|b| on the way, where the sign of b is taken, and comes out as it
;; was.  That is right with the other sign of b as well, and a result right with either sign
;; needs no assumption on it; of several, with every choice of signs.
;;
;; Whether an assumption is needed costs as much as the simplification, and is found when somebody
;; wants to know.
;;
;; A point with the other sign, at which the result differs from the question, tells at once
;; that the assumption is needed, as of √(r²) = r.  If there is none, the difference of both is
;; simplified with that sign: it is to be 0.  Declarations that make it 0 are needed then.  A
;; large expression is not examined.

(require (only-in racket/list remove-duplicates)
         "declare-relations.rkt" "simplify-expression.rkt"
         "../../error/computed-once.rkt"
         "../assumption/assumption-set.rkt" "../assumption/reference-point.rkt"
         "../assumption/relation.rkt"
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         (only-in "../expression/simplifier.rkt" left-unexpanded?)
         "../polynomial/fraction.rkt")

(provide needed-grounds simplify-expression/needed)

;; -> the simplified expression and its needs: datums, or a procedure that finds them
(define (simplify-expression/needed e A)
  (define-values (simple grounds) (simplify-expression/assumptions e A))
  (values simple (needed-grounds e simple A grounds)))

;; Nodes of the question, and assumptions looked at: each doubles the work.
(define most-nodes 400)
(define most-taken 3)

;; simple : the result of e under A and the grounds, datums such as (>= R 0)
;; -> those of the grounds that it needs: datums, or a procedure that finds them
(define (needed-grounds e simple A grounds)
  (define declared (map relation-datum (assumptions-relations A)))
  (define (taken? d) (and (not (left-unexpanded? d)) (not (member d declared))))
  (define taken (filter taken? grounds))
  (if (or (null? taken)
          (> (length taken) most-taken)
          (> (tape-length (expression->plain-tape e)) most-nodes))
      grounds
      (once (lambda () (without-idle e simple A grounds taken declared)))))

(define (without-idle e simple A grounds taken declared)
  (define-values (idle reasons) (idle-grounds e simple A taken))
  (remove-duplicates
   (append (filter (lambda (d) (member d declared)) reasons)
           (remove* idle grounds))))

;; -> those that may all be left out, and the grounds for that
(define (idle-grounds e simple A taken)
  (for/fold ([idle '()] [reasons '()]) ([d (in-list taken)])
    (define more
      (and (not (wrong-beyond? e simple A d taken))
           (reasons-for-all (for/list ([signs (in-list (choices idle))])
                              (append (cons (opposite d) signs) (remove* (cons d idle) taken)))
                            (lambda (data) (reasons-under e simple A data)))))
    (if more
        (values (cons d idle) (append more reasons))
        (values idle reasons))))

;; reasons-of : x -> list, or #f; -> all of them together, or #f
(define (reasons-for-all xs reasons-of)
  (for/fold ([all '()]) ([x (in-list xs)] #:break (not all))
    (define more (reasons-of x))
    (and more (append more all))))

;; All lists of the relations or their opposites, one for each.
(define (choices data)
  (for/fold ([lists '(())]) ([d (in-list data)])
    (for*/list ([l (in-list lists)] [c (in-list (list d (opposite d)))]) (cons c l))))

(define (opposite d)
  (cons (cdr (assq (car d) opposites)) (cdr d)))

(define opposites '((>= . <) (<= . >)))

;; Is there a point where d does not hold, the others do, and the result is wrong?
(define (wrong-beyond? e simple A d taken)
  (define others (map read-relation (cons (opposite d) (remove d taken))))
  (define there
    (struct-copy assumptions A [relations (append (assumptions-relations A) others)]))
  (define lookup (find-reference (list e) there))
  (define x (and lookup (real-value e lookup)))
  (define y (and lookup (real-value simple lookup)))
  (and x y (> (abs (- x y)) (* 1e-9 (+ 1.0 (abs x))))))

;; Is it the same under these, too?  -> the grounds, or #f.  Nothing is taken for granted
;; here; under relations that cannot hold all is true.
(define (reasons-under e simple A data)
  (with-handlers ([exn:algebra:contradiction? exn:algebra:contradiction-because])
    (define-values (F f grounds)
      (normal-form (e:- e simple) (declare-relations (with-automatic-assumptions A #f) data)))
    (and (fraction-zero? f) grounds)))
