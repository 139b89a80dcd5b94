#lang racket/base
;; Products that several monomials have in common: of a b c and a b d, a b.
;;
;; Pairs of factors that are in most monomials become factors of their own, these form pairs again,
;; until no pair is in two monomials.  A monomial that is a square is one of its root first.  The
;; order of factors changes, and with it rounding.

(require racket/list
         "sum-terms.rkt")

(provide share-products)

;; monomials : list of those with two factors or more; first-new : the first new id
;; -> monomial -> another with the same value, perhaps of new ids; new id -> its definition,
;; (product id id), or (monomial id ...) where that is one of the monomials
(define (share-products monomials first-new)
  (define short (make-hash))
  (define new (make-hasheqv))
  (define (new-factor! factor)
    (define id (+ first-new (hash-count new)))
    (hash-set! new id factor)
    id)
  (define (add! m)
    (unless (hash-ref short m #f)
      (define root (square-root m))
      (when root (add! root))
      (define id (and root (new-factor! (cons 'monomial root))))
      (hash-set! short m (if root (list id id) m))))
  (for-each add! monomials)
  (define all (sort (hash-keys short) monomial<?))
  (let again ()
    (when (share-pairs! all short new-factor!) (again)))
  (values short new))

;; The monomial of which this is the square, of two factors or more; or #f
(define (square-root m)
  (and (pair? (cddr m))
       (let half ([m m])
         (cond [(null? m) '()]
               [(and (pair? (cdr m)) (= (car m) (cadr m)))
                (define rest (half (cddr m)))
                (and rest (cons (car m) rest))]
               [else #f]))))

;; -> was there a pair?
(define (share-pairs! all short new-factor!)
  (define holders (pairs-of all short))
  (define common
    (sort (for/list ([(p ms) (in-hash holders)] #:when (pair? (cdr ms))) (list (length ms) p ms))
          (lambda (x y) (or (> (car x) (car y)) (and (= (car x) (car y)) (< (cadr x) (cadr y)))))))
  (for/fold ([any? #f]) ([x (in-list common)])
    (define-values (a b) (quotient/remainder (cadr x) pair-base))
    (define still
      (for/list ([m (in-list (caddr x))] #:when (without-pair a b (hash-ref short m))) m))
    (cond [(and (pair? still) (pair? (cdr still)))
           (define id (new-factor! (list 'product a b)))
           (for ([m (in-list still)])
             (hash-set! short m (with-factor id (without-pair a b (hash-ref short m)))))
           #t]
          [else any?])))

;; A pair of ids is one number.
(define pair-base (expt 2 28))

;; pair -> the monomials that hold it
(define (pairs-of all short)
  (define holders (make-hasheqv))
  (for ([m (in-list all)])
    (let loop ([ids (hash-ref short m)])
      (unless (null? ids)
        (for ([other (in-list (cdr ids))])
          (define p (+ (* pair-base (car ids)) other))
          (define others (hash-ref holders p '()))
          (unless (and (pair? others) (eq? (car others) m))
            (hash-set! holders p (cons m others))))
        (loop (cdr ids)))))
  holders)

;; The monomial without two factors, or #f if it does not hold both
(define (without-pair a b m)
  (define rest (and (memv a m) (without a m)))
  (and rest (memv b rest) (without b rest)))
