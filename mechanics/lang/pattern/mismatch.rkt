#lang racket/base
;; Destructuring at run time: one check of shape for each pattern, and a message that says where a
;; value departs from the pattern.

(require (only-in racket/list append-map)
         "../../algebra/expression/write.rkt"
         "../../error/complain.rkt" "../../error/hint.rkt" "../../error/message-words.rkt"
         "../../generic/describe.rkt"
         (only-in "../../generic/up-down.rkt" structure? structure-orientation structure-elements
                  up down up? down?))

(provide components short-text tuple-advice
         ;; for tests
         regrouped)

;; The components of x, known to be a tuple of that orientation and length.
;; `orientation` and `pattern`, a datum, are literals; the whole pattern and the
;; whole value it was to match are for the message alone.
(define-syntax-rule (components x orientation n who what pattern whole)
  (if (and (structure? x)
           (eq? (structure-orientation x) 'orientation)
           (eq? (vector-length (structure-elements x)) n))
      (structure-elements x)
      (other-components x 'orientation n who what 'pattern whole)))

;; A Racket vector stands for an up tuple; other values do not fit.
(define (other-components x orientation n who what pattern whole)
  (if (and (vector? x) (eq? orientation 'up) (= (vector-length x) n))
      (plain-vector x)
      (raise-mismatch who what pattern whole)))

;; Components are fetched without going through a chaperone.
(define (plain-vector v)
  (if (impersonator? v)
      (let ([copy (make-vector (vector-length v))])
        (vector-copy! copy 0 v)
        copy)
      v))

;; ---------------------------------------------------------------------------
;; The message

;; The place where a value first departs from its pattern: the path there, and the parts of value
;; and pattern.
(struct departure (path part pattern))

(define (find-departure pattern x)
  (if (fits? pattern x)
      (for/or ([p (in-list (cdr pattern))]
               [component (in-vector (elements x))]
               [i (in-naturals)])
        (define d (and (pair? p) (find-departure p component)))
        (and d (departure (cons i (departure-path d))
                          (departure-part d)
                          (departure-pattern d))))
      (departure '() x pattern)))

(define (fits? pattern x)
  (and (if (eq? (car pattern) 'up) (up? x) (down? x))
       (= (vector-length (elements x)) (length (cdr pattern)))))

(define (elements x) (if (vector? x) x (structure-elements x)))

(define (raise-mismatch who what pattern whole)
  (define d (find-departure pattern whole))
  (define path (departure-path d))
  (complain who "~a does not match the pattern ~a:~a expected ~a, given ~a~a~a"
            what (datum->text pattern)
            (if (null? path) "" (format " at ~a," (place path)))
            (expectation (departure-pattern d))
            (describe-part (departure-part d)) (hint (departure-part d))
            (if (null? path) (shape-hint pattern whole) (format "\n  in: ~a" (short-text whole)))))

;; For a tuple with the right number of parts in other groups.
(define (shape-hint pattern x)
  (define grouped (and (structure? x) (regrouped pattern x)))
  (if grouped (string-append "\n  " grouped) ""))

;; "component 0 of component 1", which (ref x 1 0) selects.
(define (place path)
  (joined (for/list ([i (in-list (reverse path))]) (format "component ~a" i)) " of "))

(define (expectation pattern)
  (format "~a ~a tuple of ~a"
          (if (eq? (car pattern) 'up) "an" "a") (car pattern) (length (cdr pattern))))

(define (describe-part x) (format "~a (~a)" (short-text x) (describe x)))

(define (hint x)
  (cond [(list? x) (string-append "; " (tuple-advice x))]
        [(and (procedure? x) (not (structure? x)))
         "; apply the function to its argument first, or use compose"]
        [else ""]))

;; Advice to write a tuple in place of the list x.
(define (tuple-advice x)
  (not-a-tuple (short-text (list->vector x))))

;; A value within a message: never longer than a few lines.
(define (short-text x)
  (parameterize ([print-limit 60]) (value->text x)))

;; ---------------------------------------------------------------------------
;; A tuple and a pattern with the same number of parts, grouped otherwise: the local tuple
;; (up t (up x y) (up vx vy)) where (up t x y vx vy) is written, or given

;; pattern : a datum; x : a tuple
;; -> a sentence that shows the names in the groups of x, or the parts of x in the groups of the
;; pattern; or #f
(define (regrouped pattern x)
  (define groups (tuple->groups x))
  (define-values (names parts) (values (leaves pattern) (leaves groups)))
  (define n (length (cdr groups)))
  (cond [(not (= (length names) (length parts))) #f]
        [(= (length (cdr pattern)) n) #f]
        [(not (ormap pair? (cdr pattern)))
         (format "~a: ~a"
                 (if (= n 3) "a local tuple has three parts" (format "the tuple has ~a parts" n))
                 (datum->text (refilled groups names cons)))]
        [(= (length parts) n)
         (define (tuple orientation parts) (apply (if (eq? orientation 'up) up down) parts))
         (parameterize ([print-limit 60])
           (format "grouped as in the pattern it is ~a"
                   (value->text (refilled pattern parts tuple))))]
        [else #f]))

;; A pattern with the parts of a tuple, each in a box, in the places of names.
(define (tuple->groups x)
  (if (structure? x)
      (cons (structure-orientation x)
            (map tuple->groups (vector->list (structure-elements x))))
      (box x)))

;; Names, or the contents of boxes, in a row.
(define (leaves p)
  (cond [(pair? p) (append-map leaves (cdr p))]
        [(box? p) (list (unbox p))]
        [else (list p)]))

;; The pattern with other leaves; make : orientation and parts -> group
(define (refilled pattern others make)
  (let fill ([p pattern])
    (cond [(pair? p) (make (car p) (for/list ([part (in-list (cdr p))]) (fill part)))]
          [else (begin0 (car others) (set! others (cdr others)))])))
