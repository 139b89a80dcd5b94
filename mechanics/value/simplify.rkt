#lang racket/base
;; The algebra of expressions, applied to every scalar of a value.

(require racket/list
         "algebra.rkt" "assumptions.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/substitute.rkt"
         "../error/complain.rkt" "../error/hint.rkt" "../error/computed-once.rkt"
         "../generic/describe.rkt" "../generic/kind.rkt" "../generic/irrational.rkt"
         "../generic/wrong-argument.rkt")

(provide expression simplify simplify-strictly simplify-always simplify/assumptions as-shown
         substitute with-literals
         raise-no-expression)

;; The plain S-expression of a value, as it prints.
(define (expression x) (value->datum x))

;; The same value with every scalar simplified, of a list of values each; functions stay as
;; they are.
(define (simplify x)
  (cond [(quoted-expression? x)
         (complain-of-argument 'simplify "a value" x (quoted-hint x))]
        [(list? x) (map simplify x)]
        [else
         (define-values (simple assumptions) (simplify/found x))
         simple]))

;; Under the declared assumptions alone.
(define (simplify-strictly x) (parameterize ([automatic-assumptions #f]) (simplify x)))

;; Independent of declarations: for values kept longer than these.
(define (simplify-always x) (call-without-assumptions (lambda () (simplify x))))

;; -> the simplified value, and the undeclared assumptions made for it
(define (simplify/assumptions x)
  (define-values (simple assumptions) (simplify/found x))
  (values simple (assumptions)))

;; -> the simplified value, and a procedure that finds the assumptions made for it
(define (simplify/found x)
  (define A (common-assumptions (assumptions-in-force) x))
  (map-expressions (lambda (e) (simplified e A)) x))

(define (simplified e A)
  (define-values (simple grounds) (simplify-expression/needed e A))
  (note-used! grounds)
  (values simple grounds))

;; -> the value as a result is shown, simplified but for scalars in a form that was asked for,
;; and the assumptions made for it
(define (as-shown x)
  (define A (common-assumptions (assumptions-in-force) x))
  (define-values (shown assumptions)
    (map-expressions (lambda (e)
                       (if (requested? e)
                           (values e (requested-assumptions e))
                           (simplified e A)))
                     x))
  (values shown (assumptions)))

;; rewrite : expression -> expression, and its assumptions or a procedure that finds them
;; -> the value, and a procedure that finds all assumptions
(define (map-expressions rewrite x)
  (define assumptions '())
  (define value
    (map-leaves
     (lambda (leaf)
       (cond [(symbolic? leaf)
              (define-values (e used) (rewrite leaf))
              (set! assumptions (cons used assumptions))
              e]
             [else leaf]))
     x))
  (value->datum value)                  ; a series gets the terms that are shown
  (values value
          (lambda ()
            (undeclared (remove-duplicates (append-map at-last (reverse assumptions)))))))

;; (substitute value 'm 3 'k (expt omega 2) ...), all at once.
(define (substitute x . names-and-replacements)
  (define alist (pair-up names-and-replacements))
  (check-order x alist)
  (map-leaves
   (lambda (leaf)
     (cond [(symbolic? leaf) (constant->number (substitute-expression leaf alist))]
           [(or (number? leaf) (other-number? leaf)) leaf]
           [else (raise-no-expression 'substitute leaf "substitute in")]))
   x))

;; In a number or another symbol there is nothing to replace.  Where the replacement is an
;; expression that holds the part it replaces, the arguments were meant in the order of scmutils.
(define (check-order x alist)
  (when (and (or (number? x) (symbol? x)) (= (length alist) 1))
    (define-values (name expression) (values (caar alist) (cdar alist)))
    (when (and (node? expression) (not (eq? x name)) (occurs? name expression))
      (complain 'substitute
                (string-append "there is nothing to replace in the ~a ~a; the expression comes "
                               "first here: (substitute ~a ~a ~a)")
                (if (number? x) "number" "symbol")
                (value->text x) (argument->text expression) (argument->text name)
                (argument->text x)))))

(define (argument->text e) (format (if (symbol? e) "'~a" "~a") (value->text e)))

(define (occurs? part e)
  (define unlike-any (string->uninterned-symbol "part"))
  (not (eq? e (substitute-expression e (list (cons part unlike-any))))))

;; use : of the value of x, if it is a function
(define (raise-no-expression who x use)
  (complain-of-argument who "an expression, or a tuple or matrix of them" x
                        (if (procedure? x)
                            (format "\n  apply the function first, and ~a its value" use)
                            (quoted-hint x))))

(define (pair-up xs)
  (cond [(null? xs) '()]
        [(null? (cdr xs))
         (complain 'substitute "expected a value, then each name with its replacement: ~a\n  ~a: ~a"
                   "(substitute x 'm 2 'k 3)"
                   "without a replacement" (describe-with-value (car xs)))]
        [else
         (define replacement (irrational-as-expression (cadr xs)))
         (check-replacement (car xs) replacement)
         (cons (cons (car xs) replacement) (pair-up (cddr xs)))]))

(define (check-replacement name replacement)
  (check-argument 'substitute symbolic? name "a symbol or an expression to replace")
  (check-argument 'substitute expression? replacement "a number or an expression as replacement"))

;; (with-literals (m k) body ...): the names stand for the symbols.
(define-syntax-rule (with-literals (name ...) body ...)
  (let ([name 'name] ...) body ...))
