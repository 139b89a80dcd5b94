#lang racket/base
;; Programs as lines of another language, to be read by people.
;;
;; A value that is used once stands where it is used, as long as the line is not; others get a
;; name.  Parentheses are where the order of operations asks for them, and sums keep theirs:
;; the results are those of our own code, to the last bit.

(require racket/list
         racket/string
         "../../compile/program.rkt"
         "../../operation/operation-column.rkt")

(provide (struct-out language) program->code number->literal indented)

;; calls   : hasheq, operation -> how it is called, a string
;; solve   : name, rows of entries, right-hand sides, all texts, is it symmetric? -> lines
;; unknown : name, index -> how an unknown of a solved system is written
;; define  : name, text -> line
(struct language (calls solve unknown define) #:authentic)

;; text : of a formula; level : of the operation that was last, as below
(struct formula (text level) #:authentic)

(define sum 1)
(define product 2)
(define atom 3)

(define longest 68)

;; names : texts of the inputs; fail : operation -> not to return
;; -> lines, and the texts of the outputs
(define (program->code p language names fail)
  (define n (program-inputs p))
  (define instructions (program-instructions p))
  (define uses (program-uses p))
  (define formulas (make-vector (+ n (program-length p)) #f))
  (for ([name (in-list names)] [k (in-range n)])
    (vector-set! formulas k (formula name atom)))
  (define (of x)
    (if (place? x)
        (vector-ref formulas (place-index x))
        (number-formula (real->double-flonum x))))
  (define lines
    (for/fold ([lines '()] #:result (reverse lines))
              ([i (in-vector instructions)] [k (in-naturals n)])
      (define name (format "v~a" k))
      (define-values (f more)
        (instruction-code i of language name (vector-ref uses k) fail))
      (vector-set! formulas k f)
      (append more lines)))
  (values lines
          (for/list ([o (in-vector (program-outputs p))]) (formula-text (of o)))))

;; -> formula, and the lines to come before it, the last first
(define (instruction-code i of language name uses fail)
  (define operation (instruction-operation i))
  (define operands (instruction-operands i))
  (case operation
    [(solve)
     (values (formula name atom)
             (reverse (system-lines language name (map of operands) (symmetric-system? i))))]
    [(component)
     (values (formula ((language-unknown language) (formula-text (of (car operands)))
                                                   (cadr operands))
                      atom)
             '())]
    [else
     (define f (operation-formula operation (map of operands) language fail))
     (if (and (= uses 1) (<= (string-length (formula-text f)) longest))
         (values f '())
         (values (formula name atom)
                 (list ((language-define language) name (formula-text f)))))]))

(define (system-lines language name entries symmetric?)
  (define n (integer-sqrt (length entries)))
  (define rows
    (let loop ([left (map formula-text entries)])
      (if (null? left) '() (cons (take left (+ n 1)) (loop (drop left (+ n 1)))))))
  ((language-solve language) name
                             (for/list ([row (in-list rows)]) (take row n))
                             (map last rows)
                             symmetric?))

(define (operation-formula operation xs language fail)
  (case operation
    [(add) (infix " + " sum xs sum product)]
    [(subtract) (infix " - " sum xs sum product)]
    [(multiply) (infix " * " product xs product atom)]
    [(divide) (infix " / " product xs product atom)]
    [(negate) (formula (string-append "-" (within (car xs) atom)) sum)]
    [else
     (define call
       (hash-ref (language-calls language) (operation-key operation (length xs))
                 (lambda () (fail operation))))
     (formula (string-append call "(" (string-join (map formula-text xs) ", ") ")") atom)]))

;; left, right : how tightly operands must bind to stand without parentheses
(define (infix sign level xs left right)
  (formula (string-append (within (car xs) left) sign (within (cadr xs) right)) level))

(define (within f level)
  (if (>= (formula-level f) level) (formula-text f) (string-append "(" (formula-text f) ")")))

(define (number-formula x)
  (formula (number->literal x) (if (or (< x 0.0) (eqv? x -0.0)) sum atom)))

;; The lines as the text of a body.
(define (indented lines)
  (string-append* (for/list ([line (in-list lines)]) (string-append "    " line "\n"))))

;; The shortest decimal that is read as x.
(define (number->literal x)
  (cond [(eqv? x +inf.0) "INFINITY"]
        [(eqv? x -inf.0) "-INFINITY"]
        [(not (= x x)) "NAN"]
        [else (number->string x)]))
