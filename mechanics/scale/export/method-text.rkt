#lang racket/base
;; The formulas of explicit methods (numeric/ode/method-formulas.rkt) as texts of other languages.

(require racket/list
         racket/string
         "program-text.rkt"
         "../../compile/program.rkt"
         "../../numeric/machine/elements.rkt"
         "../../numeric/ode/method-formulas.rkt" "../../numeric/ode/step-code.rkt")

(provide C-method-texts method-tableau)

;; Of C, by the words for them in C/dop853.c.  There vectors and numbers have the names that they
;; have here, and a and b are θ and 1 − θ.
(define (C-method-texts m language)
  (define vectors (append '(y z w old) (explicit-formulas-names m)))
  (define given (append (for/list ([v (in-list vectors)]) (cons v (format "~a[i]" v)))
                        '((h . "h") (a . "a") (b . "b"))))
  (define (loop statements targets) (C-loop given statements targets language))
  (define (stages from to part)
    (define end (stage-formulas-end part))
    (string-append*
     (append
      (for/list ([s (in-list (stage-formulas-slopes part))])
        (string-append (loop (list (reaching 'w from (rest s))) '("w[i] ="))
                       (format "    slope(w, p, ~a);\n" (first s))))
      (if end (list (loop (list (reaching to from end)) (list (format "~a[i] =" to)))) '()))))
  (hash "STAGES" (stages 'y 'z (explicit-formulas-stages m))
        "FURTHER_STAGES" (stages 'old #f (explicit-formulas-further m))
        "ERROR" (error-text m loop language)
        "WITHIN" (loop `(,@(coefficient-formulas m) (out ,(polynomial m 'a 'b))) '("out[i] ="))))

;; targets : the names that take the values of the last statements, with the sign of assignment
(define (C-loop given statements targets language)
  (define-values (lines texts) (statement-lines given statements language))
  (string-append*
   `("    for (i = 0; i < n; i++) {\n"
     ,@(for/list ([line (in-list lines)]) (format "        ~a\n" line))
     ,@(for/list ([target (in-list targets)] [text (in-list (take-right texts (length targets)))])
         (format "        ~a ~a;\n" target text))
     "    }\n")))

(define (error-text m loop language)
  (define squares (square-statements m))
  (define means (map first squares))
  (define-values (lines texts)
    (statement-lines (for/list ([x (in-list (cons 'h means))]) (cons x (symbol->string x)))
                     (error-formulas m) language))
  (define-values (above below) (apply values (take-right texts 2)))
  (string-append*
   `(,(loop squares (for/list ([e (in-list means)]) (format "~a +=" e)))
     ,@(for/list ([e (in-list means)]) (format "    ~a = sqrt(~a / n);\n" e e))
     ,@(for/list ([line (in-list lines)]) (format "    ~a\n" line))
     ,(format "    const double divisor = ~a;\n" below)
     ,(format "    return divisor == 0.0 ? 0.0 : ~a / divisor;\n" above))))

;; given : alist of names and texts -> lines, and the text of each statement's value
(define (statement-lines given statements language)
  (define-values (instructions results) (statements->instructions (map car given) statements))
  (program->code (program (length given) instructions (list->vector (map cdr results)))
                 language (map cdr given)
                 (lambda (operation) (raise-argument-error 'statement-lines "known" operation))))

;; ---------------------------------------------------------------------------

;; -> rows of the coefficients of the slopes in each stage, and those in the first mean of the
;; error, as texts
(define (method-tableau m)
  (define names (explicit-formulas-names m))
  (define (row terms count)
    (for/list ([k (in-list names)] [_ (in-range count)])
      (define term (findf (lambda (t) (eq? k (second t))) terms))
      (if term (coefficient->text (first term)) "0.0")))
  (values (for/list ([s (in-list (stage-formulas-slopes (explicit-formulas-stages m)))]
                     [count (in-naturals 1)])
            (row (rest s) count))
          (row (rest (first (mean-formulas m))) (length names))))

;; c : a number, or a fraction (fl/ p q)
(define (coefficient->text c)
  (if (pair? c) (format "~a / ~a" (second c) (third c)) (number->literal c)))
