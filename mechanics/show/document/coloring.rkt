#lang racket/base
;; The colors of a program's text: of comments, constants, and the names of forms that define and
;; bind.

(require racket/list
         syntax-color/racket-lexer)

(provide colored colored-lines)

;; text -> list of (sort . text), together the text; sort : 'comment, 'constant, 'form or #f
(define (colored text)
  (define port (open-input-string text))
  (port-count-lines! port)              ; so that positions are those of characters
  (define tokens
    (let loop ([opened? #f])
      (define-values (lexeme type paren start end) (racket-lexer port))
      (if (eof-object? lexeme)
          '()
          (let ([part (substring text (- start 1) (- end 1))])
            (cons (cons (sort-of type part opened?) part)
                  (loop (and (eq? type 'parenthesis) (regexp-match? #rx"^[([]" part))))))))
  (map joined (group-consecutive tokens)))

(define (sort-of type part opened?)
  (case type
    [(comment sexp-comment) 'comment]
    [(string constant) 'constant]
    [(symbol) (and opened? (memq (string->symbol part) forms) 'form)]
    [else #f]))

(define forms
  '(define lambda λ let let* letrec let-values define-values if cond case when unless for for/list
    for/sum for/and for/or for/vector match require provide define-syntax-rule define-syntax
    struct begin parameterize with-literals assuming module+ module))

(define (group-consecutive tokens)
  (cond [(null? tokens) '()]
        [else
         (define-values (same others)
           (splitf-at tokens (lambda (t) (eq? (car t) (car (first tokens))))))
         (cons same (group-consecutive others))]))

(define (joined tokens) (cons (car (first tokens)) (apply string-append (map cdr tokens))))

;; The same line by line, each with its newline.
(define (colored-lines text)
  (define parts
    (for*/list ([part (in-list (colored text))]
                [piece (in-list (regexp-match* #rx"[^\n]*\n|[^\n]+" (cdr part)))])
      (cons (car part) piece)))
  (let loop ([left parts])
    (define-values (before end)
      (splitf-at left (lambda (part) (not (regexp-match? #rx"\n" (cdr part))))))
    (cond [(null? left) '()]
          [(null? end) (list before)]
          [else (cons (append before (list (car end))) (loop (cdr end)))])))
