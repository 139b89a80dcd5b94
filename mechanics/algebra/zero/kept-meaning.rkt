#lang racket/base
;; Does a question still mean something where equations for its parameters hold?
;;
;; With m = 0 Lagrange's equations say nothing, with A = 0 the path A cos ωt stands still,
;; and where R = −r a path in (R + r)⁻¹ has no value.  So the equations are put into the
;; question, and at a point where all has a value one looks: all must be finite; the
;; rank of the mass matrix must not fall; a part that varied must vary.
;;
;; An equation that cannot be solved for anything is taken to be harmless.

(require racket/list
         "../assumption/assumption-set.rkt" "../assumption/reference-point.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt" "../expression/read.rkt"
         "../expression/substitute.rkt" "../expression/symbols.rkt"
         "../simplify/simplify-expression.rkt"
         "../../error/refusal.rkt")

(provide make-meaning meaning-with meaningful? independent-equations
         solutions replaced)

;; values : expressions that must have a value     matrix : rows of expressions
;; moving : expressions of which one must vary with one of the symbols `variables`
(struct meaning (values matrix moving variables) #:constructor-name make-meaning #:authentic)

;; m : a meaning, or #f of a question about which nothing is known; es : expressions that are to
;; have a value as well
(define (meaning-with es m)
  (if m
      (struct-copy meaning m [values (append es (meaning-values m))])
      (make-meaning es '() '() '())))

;; equations : as data, which shall hold together; A : assumptions
(define (meaningful? m equations A)
  (define replacements (solutions equations))
  (and replacements
       (if-raised divided-by-zero? #f
         (let* ([n (under m replacements)]
                [before (point-of m A)]
                [after (point-of n A)])
           (and after
                (or (not before)
                    (and (= (rank (meaning-matrix n) after) (rank (meaning-matrix m) before))
                         (or (varies? n after) (not (varies? m before))))))))))

;; The question with the replacements made.
(define (under m replacements)
  (define (put e) (replaced e replacements))
  (make-meaning (map put (meaning-values m))
                (for/list ([row (in-list (meaning-matrix m))]) (map put row))
                (map put (meaning-moving m))
                (meaning-variables m)))

;; -> the lookup of a point where all have values, not too great to be that, or #f
(define (point-of m A)
  (define all (append (meaning-values m) (append* (meaning-matrix m)) (meaning-moving m)))
  (define (finite? e lookup)
    (define x (real-value e lookup))
    (and x (< (abs x) too-great)))
  (define free-symbols
    (if (null? (assumptions-relations A)) (remove-duplicates (append-map symbols-in all)) '()))
  (find-reference all A (lambda (lookup)
                          (and (for/and ([s (in-list free-symbols)]) (< (abs (lookup s '())) 4))
                               (for/and ([e (in-list all)]) (finite? e lookup))))))

;; Of moderate numbers, a value beyond this is a quotient whose divisor only rounding keeps from
;; being zero.
(define too-great 1e8)

;; ---------------------------------------------------------------------------
;; Equations solved

;; -> ((expression . replacement) ...), to be made one after the other; #f if the equations
;; cannot all hold
(define (solutions equations)
  (for/fold ([done '()]) ([q (in-list equations)])
    (define (side d) (replaced (datum->expression d) (or done '())))
    (define new (and done (solution (side (cadr q)) (side (caddr q)))))
    (and new (append done new))))

(define (replaced e replacements)
  (for/fold ([e e]) ([r (in-list replacements)]) (substitute-expression e (list r))))

;; The equations without those that follow from others before; #f if they cannot all hold.
(define (independent-equations equations)
  (define (difference q) (e:- (datum->expression (cadr q)) (datum->expression (caddr q))))
  (if-raised divided-by-zero? #f
    (for/fold ([kept '()]) ([q (in-list equations)])
      (define replacements (and kept (solutions kept)))
      (define rest (and replacements
                        (simplify-expression (replaced (difference q) replacements))))
      (cond [(eqv? rest 0) kept]
            [(or (not rest) (number? rest)) #f]
            [else (append kept (list q))]))))

;; -> a list of one replacement, or of none; #f if left = right cannot hold
(define (solution left right)
  (cond [(equal? left right) '()]
        [(and (number? left) (number? right)) #f]
        [(solved-for left right) => list]
        [(solved-for right left) => list]
        [else '()]))

;; A factor of left to the first power, by the others; else a power by its root; else the
;; dividend, or the radicand.
(define (solved-for left right)
  (define factors (operands-of left op:*))
  (define (free? e)
    (and (not (number? e))
         (not (ormap (lambda (o) (shares? e o)) (cons right (remq e factors))))))
  (define (others e) (rebuild op:* (remq e factors)))
  (define s (findf (lambda (e) (and (free-symbol? e) (free? e))) factors))
  (define power (findf (lambda (e) (and (headed? e op:expt) (free? e))) factors))
  (cond [s (cons s (e:/ right (others s)))]
        [power
         (cons (car (node-args power))
               (e:expt (e:/ right (others power)) (e:/ 1 (cadr (node-args power)))))]
        [(headed? left op:/)
         (solved-for (car (node-args left)) (e:* right (cadr (node-args left))))]
        [(and (headed? left op:sqrt) (not (and (real? right) (negative? right))))
         (solved-for (car (node-args left)) (e:expt right 2))]
        [(and (eqv? right 0) (node? left)) (cons left 0)]
        [else #f]))

(define (shares? a b)
  (for/or ([s (in-list (symbols-in a))]) (occurs? s b)))

;; ---------------------------------------------------------------------------
;; Looks at a point

;; Has one of those that move other values where the variables are others?
(define (varies? m lookup)
  (for*/or ([e (in-list (meaning-moving m))] [k (in-range 1 4)])
    (define x (real-value e lookup))
    (define y (real-value e (elsewhere lookup (meaning-variables m) k)))
    (or (not (and x y))
        (> (abs (- x y)) (* 1e-9 (+ (abs x) (abs y)))))))

;; The variables a little further, each by another step.
(define ((elsewhere lookup variables k) leaf arguments)
  (define i (and (symbol? leaf) (index-of variables leaf eq?)))
  (define x (lookup leaf arguments))
  (if i (+ x (* k (/ 0.37 (+ i 1.3)))) x))

;; The rank of a matrix of expressions at a point, by elimination.
(define (rank matrix lookup)
  (define rows
    (for/list ([row (in-list matrix)]) (for/list ([e (in-list row)]) (real-value e lookup))))
  (define size (for*/fold ([s 0]) ([row (in-list rows)] [x (in-list row)]) (max s (abs x))))
  (let loop ([rows rows] [rank 0])
    (define pivot-row
      (and (pair? rows) (pair? (car rows)) (argmax (lambda (r) (abs (car r))) rows)))
    (cond [(not pivot-row) rank]
          [(<= (abs (car pivot-row)) (* 1e-9 size)) (loop (map cdr rows) rank)]
          [else
           (loop (for/list ([r (in-list (remq pivot-row rows))])
                   (define c (/ (car r) (car pivot-row)))
                   (for/list ([x (in-list (cdr r))] [p (in-list (cdr pivot-row))])
                     (- x (* c p))))
                 (+ rank 1))])))
