#lang racket/base
;; The state of a search for kernels, and its findings.

(require "integer-lattice.rkt" "kernel.rkt"
         "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt" "../expression/order.rkt" "../expression/simplifier.rkt")

(provide
 ;; resolutions of a node
 (struct-out circular) (struct-out surd) (struct-out exponential-power) (struct-out alias)
 ;; the collector
 (struct-out collector) make-collector
 resolve! resolve-alias! intern-kernel! add-relation!
 ;; linear forms over atoms
 linear-form form->expression intern-angle! sort-forms)

;; A node that is not arithmetic is a kernel, or one of these:
;; function ∈ sin cos tan sinh cosh tanh of an angle;
(struct circular (function angle) #:authentic)
;; outer^power · (root^degree-of-root)^(power/degree);
(struct surd (outer root degree power) #:authentic)
;; a product of powers of basic exponentials;
(struct exponential-power (angle) #:authentic)
;; another expression.
(struct alias (expression) #:authentic)

;; visit : expression -> void, the walk itself, for expressions that stand for
;; others.  resolutions : node, symbol or odd number -> its resolution.
;; angles : (kind . form) -> angle, for the kinds 'circular, 'hyperbolic and
;; 'exponential.  logarithms : simplified argument -> nodes.  roots : radicand ->
;; root.  tower : roots, and kernels of absolute values, the last met first: so
;; those within others come after them.  inexact?, inexact-forms? : did a flonum
;; occur, in arithmetic or in a form?
(struct collector (simplifier visit root blocked kernels resolutions atoms angles logarithms
                   roots [tower #:mutable] [inexact? #:mutable] [inexact-forms? #:mutable])
  #:authentic)

(define (make-collector s visit root blocked)
  (collector s visit root blocked
             (make-hash) (make-hasheqv) (make-atoms) (make-hash) (make-hash)
             (make-hash) '() #f #f))

(define (resolve! c n resolution)
  (hash-set! (collector-resolutions c) n resolution))

;; Lets the expression e stand for the node n.
(define (resolve-alias! c n e)
  ((collector-visit c) c e)
  (resolve! c n (alias e)))

(define (intern-kernel! c expression [relation #f])
  (hash-ref! (collector-kernels c) expression (lambda () (make-kernel expression relation))))

(define (add-relation! c r)
  (unless (memq r (collector-tower c))
    (set-collector-tower! c (cons r (collector-tower c)))))

;; ---------------------------------------------------------------------------
;; Linear forms

;; Atoms are numbered as they come: expression -> key, and key -> expression.
(struct atoms (keys expressions) #:authentic)
(define (make-atoms) (atoms (make-hash) (make-hasheqv)))

(define (atom-key! table e)
  (define keys (atoms-keys table))
  (define k (hash-ref! keys e (lambda () (hash-count keys))))
  (hash-set! (atoms-expressions table) k e)
  k)

;; A longer sum than this is an atom of its own.
(define form-limit 40)

;; The sum of ((number . expression) ...) as a vector over atoms.
(define (linear-form c terms)
  (define few
    (if (> (length terms) form-limit)
        (list (cons 1 (make-node op:+ (for/list ([t (in-list terms)]) (e:* (car t) (cdr t))))))
        terms))
  (for/fold ([form '()]) ([t (in-list few)])
    (unless (exact? (car t)) (set-collector-inexact-forms?! c #t))
    (vector-add form (list (cons (atom-key! (collector-atoms c) (cdr t))
                                 (inexact->exact (car t)))))))

(define (form->expression c form)
  (define expressions (atoms-expressions (collector-atoms c)))
  (sum-of-terms (for/list ([entry (in-list form)])
                  (cons (present-number (cdr entry) (collector-inexact-forms? c))
                        (hash-ref expressions (car entry))))))

(define (intern-angle! c kind form)
  (hash-ref! (collector-angles c) (cons kind form) (lambda () (angle form #f))))

;; Angles with the simplest forms first: fewest atoms, then by the order of
;; expressions.
(define (sort-forms c angles)
  (define compare (make-order))
  ;; how many atoms, and the later of the angle and its opposite
  (define (key a)
    (define form (angle-form a))
    (define u (form->expression c form))
    (define v (form->expression c (vector-scale -1 form)))
    (cons (length form) (if (< (compare u v) 0) v u)))
  (define (simpler? a b)
    (or (< (car a) (car b))
        (and (eqv? (car a) (car b)) (< (compare (cdr a) (cdr b)) 0))))
  (sort angles simpler? #:key key #:cache-keys? #t))
